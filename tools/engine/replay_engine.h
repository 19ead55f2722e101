#pragma once

#include <optional>
#include <string>

#include "tools/output/exit.h"
#include "tumble/replay/log_reader.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// `replay` of another engine's log: options of the command.
struct EngineReplay {
  std::string scene;                     ///< {scene}; empty: the text in the log, else that of tumble.toml
  std::string output;                    ///< where the new session is kept; empty: nowhere
  bool no_build = false;                 ///< run the engine as it is
  bool stop = false;                     ///< end the engine at the first difference
  std::optional<double> timeout_s = {};  ///< of the run; none: that of tumble.toml
  bool brief = false;
  bool json = false;
};

/// Builds and runs the engine of the nearest tumble.toml with the inputs of its log, and compares the new session with
/// the log, while the engine runs and in full when it has ended. Of an engine that does not run to its end, the steps
/// that it wrote are compared: a difference in them is the answer, else the failure is an error. Errors: no tumble.toml
/// or a wrong one; an engine that cannot be built or run; logs that cannot be compared.
Result<Exit> replay_engine(replay::LogReader& log, const EngineReplay& options);

}  // namespace tumble::tools
