#include "tools/bisect/engine_settings.h"

#include <optional>
#include <system_error>

#include "golden/engine/project.h"

namespace tumble::tools::bisect {
namespace {

namespace fs = std::filesystem;

/// The nearest folder with git's own folder or file in it.
fs::path clone_of(const fs::path& folder) {
  std::error_code error;
  for (fs::path at = folder;; at = at.parent_path()) {
    if (fs::exists(at / ".git", error)) return at;
    if (at == at.parent_path()) return {};
  }
}

}  // namespace

Status take_project(const fs::path& from, Settings& settings) {
  const Result<std::optional<golden::EngineProject>> found = golden::find_project(from);
  if (!found.ok()) return found.error();
  if (!*found) return {};
  const golden::EngineProject& project = **found;
  const fs::path clone = clone_of(project.folder);
  if (clone.empty())
    return bad_input(project.file.string() + ": lies in no clone of git, whose revisions could be asked");
  settings.engine_folder = project.folder.lexically_relative(clone).string();
  settings.engine_scene = project.scene;
  settings.engine_table = project.table;
  settings.shell = project.shell;
  if (settings.build.empty()) settings.build = project.build;
  if (settings.case_name.empty()) settings.run = project.run;
  if (settings.timeout_s == 0) settings.timeout_s = project.timeout_s;
  settings.has_project = true;
  std::error_code error;
  if (settings.program.empty()) settings.program = fs::read_symlink("/proc/self/exe", error).string();
  return {};
}

}  // namespace tumble::tools::bisect
