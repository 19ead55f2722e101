#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tumble/replay/recorder.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"

/// The places where a session may start: a scene, or a state of a log.
namespace tumble::tools {

/// A scene that is read, ready to record.
struct SceneStart {
  std::string name;  ///< of the case or the file; logs are named after it
  std::string path;  ///< of the scene file
  sim::SceneDef scene;
  replay::RecordOptions how;
};

/// Reads a scene that the command line names. `how`: its overrides are applied. Errors: find_scene's, the scene's.
Result<SceneStart> read_scene_start(const std::string& scene, replay::RecordOptions how);

/// The argument LOG:STEP.
struct LogPlace {
  std::string log;
  std::uint64_t step = 0;

  /// "<log>_from_<step>", without the log's folder and ending.
  [[nodiscard]] std::string name() const;
};
Result<LogPlace> parse_log_place(const std::string& text);

}  // namespace tumble::tools
