#pragma once

#include <string>
#include <vector>

#include "tumble/sim/result.h"

/// Finds scenes: files by their path, golden cases by their name.
namespace tumble::tools {

struct SceneFile {
  std::string name;  ///< of the case, or the file's name without its ending; the log's default name
  std::string path;
};

/// The folder of the suite: the nearest `golden` with a folder `cases` in it from the current one upwards, else that of
/// data_folder(). Relative to the current folder where that is shorter.
std::string find_suite();

/// The golden cases, by name: every `golden/cases/<name>/scene.toml` of the nearest folder `golden/cases` from the
/// current one upwards, else of data_folder(). Empty if there is neither.
std::vector<SceneFile> find_cases();

/// SCENE as the command line gives it: a file, or a case's name. Errors (kBadInput): neither, with the nearest name.
Result<SceneFile> find_scene(const std::string& scene);

/// A scene file's text. Errors (kBadInput): missing, a folder, no permission, larger than any scene.
Result<std::string> read_scene(const std::string& path);

}  // namespace tumble::tools
