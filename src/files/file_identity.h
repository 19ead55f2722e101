#pragma once

#include <sys/types.h>

#include <compare>
#include <filesystem>
#include <optional>

namespace tumble::files {

/// Device and inode: one file has one identity under all its names, hard links and symbolic links included.
struct FileIdentity {
  dev_t device = 0;
  ino_t inode = 0;
  friend auto operator<=>(const FileIdentity&, const FileIdentity&) = default;
};

/// The identity of the file or folder that `path` leads to; none where there is none.
std::optional<FileIdentity> identity_of(const std::filesystem::path& path);
std::optional<FileIdentity> identity_of(const char* path);  ///< allocates nothing

/// The place that an output to `path` is written to: symbolic links are followed, also one that leads to no file yet.
std::filesystem::path resolved(const std::filesystem::path& path);

/// The folder that holds `path`; "." for a name alone.
std::filesystem::path folder_of(const std::filesystem::path& path);

}  // namespace tumble::files
