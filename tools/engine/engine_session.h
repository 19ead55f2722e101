#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "golden/engine/project.h"
#include "tools/engine/session_watch.h"
#include "tumble/replay/log_reader.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// A step whose probes the engine writes, and the file for them.
struct ProbedStep {
  std::uint64_t step = 0;
  std::string file;
};

/// How an engine computes the session of a log anew.
struct EngineSessionOptions {
  std::string scene;                 ///< {scene}; empty: the text in the log, else that of the project
  bool no_build = false;             ///< run the engine as it is
  std::optional<ProbedStep> probed;  ///< none: without probes
  double timeout_s = 0;              ///< of the run; 0: that of the project
  SessionWatch* watch = nullptr;     ///< looks at the session while the engine runs; may be null
};

/// A session that an engine computed anew.
struct EngineSession {
  bool gets_inputs = true;            ///< its command has {inputs}
  std::string log;                    ///< its path, in the folder given
  std::string command;                ///< as a person would type it
  std::vector<std::string> warnings;  ///< of a table or a stream
  std::string unfinished;             ///< why the session may lack its end, though the engine ended well; or empty
  /// Why the engine did not run to its end: a crash, its time, the watch. The log has the steps before. Empty: it did.
  std::string failure;
  bool stopped = false;  ///< by the watch
};

/// The project of the nearest tumble.toml from the current folder upwards. log: of another engine, for the message.
/// Errors: none there, or a wrong one.
Result<golden::EngineProject> project_for(const replay::LogReader& log);

/// Builds and runs the engine with the scene and the inputs of a log, and makes a log of what it wrote. folder: a new
/// one, for all files. Errors: an engine that cannot be built or run, a session that is none.
Result<EngineSession> run_engine_session(replay::LogReader& log, const golden::EngineProject& project,
                                         const EngineSessionOptions& options, const std::filesystem::path& folder);

}  // namespace tumble::tools
