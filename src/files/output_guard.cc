#include "src/files/output_guard.h"

#include <optional>
#include <system_error>

#include "src/base/text.h"

namespace tumble::files {
namespace {

namespace fs = std::filesystem;

/// A folder with these two is a case of a golden suite; `record` and `measure` may stand in any folder and know no
/// suite.
constexpr const char* kSceneOfCase = "scene.toml";
constexpr const char* kRulesOfCase = "metrics.toml";
constexpr const char* kGoldenOfCase = "expected.tumble";

bool is_golden(const fs::path& place) {
  std::error_code ignored;
  const fs::path folder = folder_of(place);
  const std::string name = place.filename().string();
  if (name == "HISTORY.md") return fs::is_directory(folder / "cases", ignored);
  const bool named_so =
      name == kSceneOfCase || name == kRulesOfCase || name == kGoldenOfCase || place.extension() == ".png";
  return named_so && fs::exists(folder / kSceneOfCase, ignored) && fs::exists(folder / kRulesOfCase, ignored);
}

Error refused(const std::string& option, const fs::path& path, const std::string& why) {
  return bad_input(option + ": " + printable(path.string()) + ": " + why);
}

}  // namespace

std::string OutputGuard::Name::text(const fs::path& found) const {
  return about + (path == found ? " itself" : " itself, " + printable(path));
}

void OutputGuard::keep(const fs::path& path, const std::string& about) {
  const std::optional<FileIdentity> identity = identity_of(path);
  if (identity) files_.emplace(*identity, Name{path.string(), about});
}

void OutputGuard::keep_folder(const fs::path& folder, const std::string& about) {
  const std::optional<FileIdentity> identity = identity_of(folder);
  if (!identity || !folders_.emplace(*identity, Name{folder.string(), about}).second) return;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code ignored;
    if (fs::is_directory(at->path(), ignored)) {
      keep_folder(at->path(), about);
    } else {
      keep(at->path(), about);
    }
  }
}

Status OutputGuard::outside_kept_folders(const std::string& option, const fs::path& path) const {
  std::error_code error;
  fs::path folder = fs::weakly_canonical(fs::absolute(path, error), error);
  for (; !error; folder = folder.parent_path()) {
    const std::optional<FileIdentity> identity = identity_of(folder);
    const auto kept = identity ? folders_.find(*identity) : folders_.end();
    if (kept != folders_.end()) {
      return refused(option, path,
                     "lies in " + printable(kept->second.path) + ", a folder of " + kept->second.about +
                         ", which this command only reads; name another place");
    }
    if (folder == folder.parent_path()) break;
  }
  return {};
}

Status OutputGuard::claim(const std::string& option, const fs::path& path) {
  if (path == "-") return refused(option, path, "is no name of an output; name a file, ./- for one of that name");
  const fs::path place = resolved(path);
  const std::optional<FileIdentity> identity = identity_of(place);
  std::error_code ignored;
  if (fs::is_directory(place, ignored)) return refused(option, path, "is a folder; name a file");
  if (const auto kept = identity ? files_.find(*identity) : files_.end(); kept != files_.end()) {
    return refused(option, path,
                   "is " + kept->second.text(path) + ", which this command only reads; name another file");
  }
  if (Status ok = outside_kept_folders(option, folder_of(place)); !ok.ok()) return ok;
  if (identity && is_golden(place)) {
    return refused(option, path, "is a file of a golden case, which nothing but bless changes; name another file");
  }
  const std::optional<FileIdentity> folder = identity_of(folder_of(place));
  const bool is_device = identity && !fs::is_regular_file(place, ignored);
  if (!folder || is_device) return {};
  const auto [other, is_first] = claimed_.try_emplace({*folder, place.filename().string()}, option);
  if (is_first) return {};
  return refused(option, path, "is the file of " + other->second + " too; name another file");
}

Status OutputGuard::claim_folder(const std::string& option, const fs::path& folder) {
  if (Status ok = outside_kept_folders(option, folder); !ok.ok()) return ok;
  std::set<FileIdentity> seen;
  return holds_nothing_kept(option, folder, seen);
}

Status OutputGuard::holds_nothing_kept(const std::string& option, const fs::path& folder,
                                       std::set<FileIdentity>& seen) const {
  const std::optional<FileIdentity> own = identity_of(folder);
  if (!own || !seen.insert(*own).second) return {};
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::optional<FileIdentity> identity = identity_of(at->path());
    if (!identity) continue;
    for (const Kept* kept : {&files_, &folders_}) {
      if (const auto found = kept->find(*identity); found != kept->end()) {
        return refused(option, folder,
                       "holds " + printable(found->second.path) + ", " + found->second.about +
                           ", which this command only reads; name another folder");
      }
    }
    std::error_code ignored;
    if (!fs::is_directory(at->path(), ignored)) continue;
    if (Status ok = holds_nothing_kept(option, at->path(), seen); !ok.ok()) return ok;
  }
  return {};
}

}  // namespace tumble::files
