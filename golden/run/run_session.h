#pragma once

#include <string>

#include "replay/log/byte_memory.h"
#include "tumble/replay/log_reader.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"

namespace tumble::golden {

/// A recorded session in memory.
struct Session {
  replay::MemoryFile log;
  Hash128 continuation;  ///< of the last state; zero where it is not known (another engine's)
  std::string failure;   ///< why it ended early; empty: it did not
  double seconds = 0;    ///< of wall time that it took
  /// Another engine's command failed, and these are the steps that it wrote before.
  bool cut_short = false;
  bool was_converted = false;  ///< another engine wrote it as a table or a stream
};

/// Runs a scene with this build. Errors: a world that cannot be made.
Result<Session> run_session(const sim::SceneDef& scene, const std::string& scene_text);

/// Opens the session as a log. name: for messages.
Result<replay::LogReader> open_session(const Session& session, const std::string& name);

}  // namespace tumble::golden
