#include "src/files/file_identity.h"

#include <sys/stat.h>

#include <system_error>

namespace tumble::files {
namespace {

namespace fs = std::filesystem;

constexpr int kLinksMax = 40;  // as many as Linux follows

}  // namespace

std::optional<FileIdentity> identity_of(const fs::path& path) { return identity_of(path.c_str()); }

std::optional<FileIdentity> identity_of(const char* path) {
  struct stat info = {};
  if (::stat(path, &info) != 0) return std::nullopt;
  return FileIdentity{info.st_dev, info.st_ino};
}

fs::path resolved(const fs::path& path) {
  fs::path place = path;
  std::error_code error;
  for (int links = 0; links < kLinksMax && fs::is_symlink(fs::symlink_status(place, error)); ++links) {
    const fs::path next = fs::read_symlink(place, error);
    if (error) break;
    place = next.is_absolute() ? next : folder_of(place) / next;
  }
  return place;
}

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

}  // namespace tumble::files
