#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tumble/golden/suite.h"
#include "tumble/sim/result.h"

/// Hashes of files, 32 hexadecimal digits of XXH3-128, by which a merge knows suites, programs and damage.
namespace tumble::golden {

struct FileHash {
  std::uint64_t bytes = 0;
  std::string hash;
};

/// Of a file's content, read in pieces. Errors (kBadInput): missing, a folder, no permission.
Result<FileHash> hash_file(const std::filesystem::path& path);

/// Of this program's file; "not known" where the system has no /proc.
std::string program_hash();

/// Of the paths and contents of all files below the suite's cases, and of the tumble.toml that builds its engine; of
/// the error in place of what cannot be read, which the case's own run reports. HISTORY.md decides no verdict and is
/// not part of it.
std::string suite_hash(const Suite& suite);

/// Of names in their order.
std::string names_hash(const std::vector<std::string>& names);

}  // namespace tumble::golden
