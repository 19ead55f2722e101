#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tumble::golden {

/// A line of a scene that changed. Comments, blanks, title, name, category, textures, camera and light do not
/// count: they make no golden stale.
struct SceneChange {
  std::size_t line = 0;  ///< 1-based, in the scene as it is now; of a line that is gone, in the old one
  std::string table;     ///< "[world]", "[[box]]"; empty above the first table; of an engine's case: the file
  std::string before;    ///< "gravity = [0, 0, -9.81]"; empty: the line is new
  std::string after;     ///< empty: the line is gone
  friend bool operator==(const SceneChange&, const SceneChange&) = default;
};

/// "line 5, [world]: gravity = [0, 0, -9.81] → [0, 0, -9.8]"; "line 7, [[box]]: new: frozen = true";
/// "scene.txt, line 3: box 1 → box 2".
std::string describe(const SceneChange& change);

/// The lines by which two texts of a scene differ, in the order of the new one.
std::vector<SceneChange> scene_changes(std::string_view before, std::string_view after);

}  // namespace tumble::golden
