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

/// "3 inputs are planned behind step 10, the last one, and not given; the first: throw before step 12"; empty where a
/// session has all of them. `recorded` has no inputs of `scene` behind the end of a session that an option shortens, so
/// the scene is read again. scene: empty where the session goes on from a log.
std::string inputs_left_out(const std::string& scene, const std::vector<std::string>& overrides,
                            const sim::SceneDef& recorded);

/// The argument LOG:STEP.
struct LogPlace {
  std::string log;
  std::uint64_t step = 0;

  /// "<log>_from_<step>", without the log's folder and ending.
  [[nodiscard]] std::string name() const;
};
Result<LogPlace> parse_log_place(const std::string& text);

}  // namespace tumble::tools
