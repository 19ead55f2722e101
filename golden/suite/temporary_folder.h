#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "tumble/sim/result.h"

namespace tumble::golden {

/// Whether files can be written in the system's place for temporary files: one of so many bytes (a full disk takes
/// none) and small ones beside it. Errors (kCannotFinish): the place, what is wrong with it, and how to name another.
Status check_temporary_place(std::size_t bytes = 512, std::size_t files = 1);

/// A new folder for temporary files, named PREFIX-PROCESS-XXXXXX in `within` or the system's place for them, removed
/// with this object, by the signal that ends the program or, where that was SIGKILL, by the next program that makes a
/// folder of this prefix there. The path is empty if no folder could be made.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const std::string& prefix, const std::filesystem::path& within = {});
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace tumble::golden
