#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

#include "tumble/sim/result.h"

namespace tumble::golden {

/// Whether files can be written in the system's place for temporary files. Errors (kCannotFinish): the place, what is
/// wrong with it, and how to name another.
Status check_temporary_place();

/// A new folder for temporary files, named PREFIX-XXXXXX in `within` or the system's place for them, removed with this
/// object. The path is empty if no folder could be made.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const std::string& prefix, const std::filesystem::path& within = {}) {
    std::error_code error;
    const std::filesystem::path place = within.empty() ? std::filesystem::temp_directory_path(error) : within;
    if (error) return;
    std::string pattern = (place / (prefix + "-XXXXXX")).string();
    if (::mkdtemp(pattern.data()) != nullptr) path_ = pattern;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace tumble::golden
