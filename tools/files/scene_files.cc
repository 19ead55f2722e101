#include "tools/files/scene_files.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>
#include <string_view>
#include <system_error>

#include "src/base/text.h"
#include "tools/files/data_folder.h"
#include "tumble/replay/prelude.h"

namespace tumble::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kSceneBytesMax = 64 << 20;  // the parser has the limit that counts; this one bounds memory

fs::path suite_folder() {
  std::error_code error;
  for (fs::path folder = fs::current_path(error); !error; folder = folder.parent_path()) {
    fs::path suite = folder / "golden";
    if (fs::is_directory(suite / "cases", error)) return suite;
    error.clear();
    if (folder == folder.parent_path()) break;
  }
  return data_folder() / "golden";
}

/// A project's own cases go before those that came with the program.
std::vector<fs::path> case_folders() {
  std::vector<fs::path> folders = {suite_folder() / "cases"};
  const fs::path installed = data_folder() / "golden" / "cases";
  std::error_code error;
  if (folders.front() != installed && !fs::equivalent(folders.front(), installed, error)) folders.push_back(installed);
  return folders;
}

bool looks_like_path(const std::string& text) { return text.find('/') != std::string::npos || text.ends_with(".toml"); }

Error unknown_case(const std::string& scene, const std::vector<SceneFile>& cases) {
  std::vector<std::string_view> names;
  names.reserve(cases.size());
  for (const SceneFile& known : cases) names.push_back(known.name);
  std::string looked;
  for (const fs::path& folder : case_folders()) looked += (looked.empty() ? "" : " or ") + printable(folder.string());
  const std::string_view nearest = nearest_word(scene, names);
  const std::string hint = nearest.empty() ? "" : "; did you mean \"" + std::string(nearest) + "\"?";
  return bad_input("no scene " + in_quotes(scene) + ": neither a file nor a golden case of " + looked + hint +
                   "\n'tumble scenes' lists the cases; a file's name ends in .toml.");
}

}  // namespace

std::string find_suite() {
  std::error_code error;
  const std::string whole = suite_folder().string();
  const std::string relative = fs::proximate(whole, error).string();
  return !error && relative.size() < whole.size() ? relative : whole;
}

std::vector<SceneFile> find_cases() {
  std::vector<SceneFile> cases;
  for (const fs::path& folder : case_folders()) {
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
      const fs::path scene = at->path() / "scene.toml";
      std::error_code ignored;
      std::string name = at->path().filename().string();
      const bool is_known = std::ranges::find(cases, name, &SceneFile::name) != cases.end();
      if (!is_known && fs::is_regular_file(scene, ignored)) cases.push_back({std::move(name), scene.string()});
    }
  }
  std::ranges::sort(cases, {}, &SceneFile::name);
  return cases;
}

Result<SceneFile> find_scene(const std::string& scene) {
  std::error_code error;
  const fs::path path(scene);
  const bool exists = fs::exists(path, error);
  if (exists && !fs::is_directory(path, error)) return SceneFile{path.stem().string(), scene};
  if (!looks_like_path(scene)) {
    const std::vector<SceneFile> cases = find_cases();
    const auto found = std::ranges::find(cases, scene, &SceneFile::name);
    if (found != cases.end()) return *found;
    if (!exists) return unknown_case(scene, cases);
  }
  if (exists) return bad_input(scene + ": found a folder, wanted a scene file (.toml) or the name of a golden case");
  return bad_input(scene + ": no such file; 'tumble scenes' lists the scenes that have a name");
}

Result<std::string> read_scene(const std::string& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) return bad_input(path + ": cannot be opened: " + std::strerror(errno));
  std::string text;
  std::string block(1 << 16, '\0');
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0) {
    text.append(block, 0, static_cast<std::size_t>(file.gcount()));
    if (text.size() > kSceneBytesMax) return bad_input(path + ": longer than any scene; is this the right file?");
  }
  if (file.bad()) return cannot_finish(path + ": cannot be read: " + std::strerror(errno));
  const auto start = std::as_bytes(std::span(text)).first(std::min(text.size(), replay::kMagicEnd));
  if (start.size() == replay::kMagicEnd && replay::starts_like_log(start)) {
    return bad_input(path +
                     ": is a log or a golden, wanted a scene (.toml) or the name of a golden case; 'tumble info' "
                     "reads logs, and 'tumble record --from LOG:STEP' goes on from one");
  }
  return text;
}

}  // namespace tumble::tools
