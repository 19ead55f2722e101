#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "golden/hunt/apart/session_pair.h"
#include "golden/hunt/scene/scene_text.h"
#include "golden/suite/temporary_folder.h"
#include "tumble/replay/log_reader.h"

namespace tumble::hunt {

/// The session of a scene by another build, recorded when it is first judged and only once.
class OtherBuild {
 public:
  /// All outlive this. program: the other build. within: none, bits are compared. scratch: where it gets a folder;
  /// empty: the system's place. The trace is of the scene.
  OtherBuild(const std::string& program, const std::vector<ApartBound>& within, const std::filesystem::path& scratch,
             const Trace& trace, const TextScene& scene)
      : program_(program), within_(within), scratch_(scratch), trace_(trace), scene_(scene) {}

  /// kAgainst: compare_bits(), or with bounds: the same start, and the other build takes the scene to its last step
  /// too. relation_of() a bound: its measure is within it; not applicable where there is no whole session.
  Judgement judge(const std::string& relation);

 private:
  Judgement judge_session();
  Judgement record();
  Judgement read_records();

  const std::string& program_;
  const std::vector<ApartBound>& within_;
  const std::filesystem::path& scratch_;
  const Trace& trace_;
  const TextScene& scene_;
  std::unique_ptr<golden::TemporaryFolder> folder_;  // goes after the log
  std::optional<replay::LogReader> log_;             // of the other build
  std::optional<Judgement> session_;                 // of kAgainst
  std::optional<SessionPair> pair_;                  // with bounds, of whole sessions
};

}  // namespace tumble::hunt
