#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "golden/hunt/folder.h"
#include "golden/hunt/judge_scene.h"
#include "tumble/process/job_pool.h"
#include "tumble/sim/result.h"

namespace tumble::hunt {

/// A folder of scenes, NAME.toml each, that between them do everything that any of them does (features_of()). Names
/// come from the content, so two corpora are merged by adding the scenes of one to the other.
class Corpus {
 public:
  /// Reads and runs every scene of a folder; one that is missing is an empty corpus. Errors: every file that is
  /// no scene, kDamaged where one was cut or changed since it got its name.
  static Result<Corpus> open(const std::filesystem::path& folder);

  /// Adds a scene that does something new, and writes its file at once. Returns whether it did. Errors: the disk.
  Result<bool> add(const TextScene& scene, const std::vector<std::string>& features);

  /// Adds the scenes of another corpus. Returns how many were added.
  Result<std::size_t> merge(const std::filesystem::path& other);

  [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }
  [[nodiscard]] const std::set<std::string>& features() const { return features_; }

 private:
  explicit Corpus(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::filesystem::path folder_;
  std::vector<std::filesystem::path> files_;  // ascending
  std::set<std::string> features_;
};

/// The scenes of a folder judged, one a process.
struct CorpusResult {
  std::size_t scenes = 0;
  std::size_t refused = 0;           ///< by the engine
  std::string refusal;               ///< the first
  std::string engine;                ///< the command of the engine; empty: this program is judged
  std::vector<std::string> claimed;  ///< relations that the engine claims
  Tallies relations;
  struct Broken {
    std::string file, relation;
    Judgement judgement;
    std::string judging = {};  ///< as Finding has it
  };
  std::vector<Broken> broken;  ///< by file
};
/// Errors (kBadInput): no such folder, a folder without scenes; open()'s; kCannotFinish: cancelled.
Result<CorpusResult> judge_corpus(const std::filesystem::path& folder, const Question& question,
                                  const process::PoolOptions& pool);
Json to_json(const CorpusResult& result);

/// Whether no session was judged by anything that is asked, as of a hunt.
bool nothing_judged(const CorpusResult& result);

/// As of a hunt.
std::string judges_error(const CorpusResult& result);

/// False where a scene broke a relation; of an engine, one that it claims, or ended the program.
bool claims_hold(const CorpusResult& result);

}  // namespace tumble::hunt
