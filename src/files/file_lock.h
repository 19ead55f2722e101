#pragma once

#include <filesystem>
#include <string>

#include "tumble/sim/result.h"

namespace tumble::files {

/// Locks an open file against other writers until it is closed, at the latest by the end of the process. True where the
/// file system knows no locks.
bool lock(int file);

/// "process 812 (tumble record tower -o x.tumble)", which has locked an open file; "" where nobody knows.
std::string holder_of(int file);

/// The lock of a folder that one process at a time may work in: a file of its own in it, which goes with this object.
class FolderLock {
 public:
  /// Makes the folder. name: of the file. what: for messages: "a hunt". Errors: kBadInput: another process works there;
  /// cannot_open()'s.
  static Result<FolderLock> take(const std::filesystem::path& folder, const std::string& name, const std::string& what);
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();

 private:
  FolderLock(std::filesystem::path path, int file) : path_(std::move(path)), file_(file) {}

  std::filesystem::path path_;
  int file_;
};

}  // namespace tumble::files
