#pragma once

#include <string>
#include <vector>

#include "golden/engine/engine_run.h"
#include "tools/bisect/settings.h"
#include "tools/bisect/workplace.h"
#include "tumble/golden/suite.h"
#include "tumble/sim/result.h"

namespace tumble::tools::bisect {

/// The command line by which a revision records the session of the question.
class Recording {
 public:
  /// Both must outlive this object.
  Recording(const Settings& settings, const Workplace& place) : settings_(settings), place_(place) {}

  /// Writes the scene and the inputs of the log into the workplace. Errors: the log's; kBadInput where the session
  /// cannot be recorded anew and the question needs that.
  Status prepare();

  struct Command {
    std::vector<std::string> words;
    std::string folder;
  };
  /// The command that writes `session` at the revision in place. Errors: those of the revision's own rules and
  /// tumble.toml.
  [[nodiscard]] Result<Command> command(const std::string& session) const;

  /// Makes a log of what the command wrote to `session`: an engine may write a table. Errors: session_file.h's.
  [[nodiscard]] Status make_log(const std::string& session) const;

  /// Whether the case that is asked about has an engine of its own at the revision in place: its build may make more
  /// than the program, so that a program that was kept is not all that is needed.
  [[nodiscard]] bool runs_engine() const;

  [[nodiscard]] std::string program() const;  ///< of the revision: the one that its build made, or a kept one
  /// A program that was kept, in place of the one that a build makes; empty: none.
  void use_kept(const std::string& program) { kept_ = program; }
  [[nodiscard]] const std::string& kept() const { return kept_; }
  [[nodiscard]] std::string suite() const { return place_.source() + "/golden"; }

  /// The engine of the settings in the clone.
  [[nodiscard]] golden::EngineProject engine() const;

 private:
  [[nodiscard]] Result<Command> case_command(const std::string& session) const;
  [[nodiscard]] golden::CaseFolder case_folder() const;

  const Settings& settings_;
  const Workplace& place_;
  std::vector<std::string> record_words_;  // without the program and the log to write; empty: it cannot be recorded
  std::string kept_;
  golden::RunFiles files_;  // of an engine; without a log
};

}  // namespace tumble::tools::bisect
