#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "golden/engine/project.h"
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

/// Of the file of a program that a path or a name in PATH leads to; "not known" where neither does.
std::string program_hash(const std::string& program);

/// Of the files of an engine: of each word of its command that names one from the engine's folder, and of its program
/// where PATH finds that, and of the integrator that it names. A command of a shell is split as words alone. "not
/// known" where no word is a file. What such a file loads is not part of it.
std::string engine_hash(const EngineProject& project);

/// Of the paths and contents of all files below the suite's cases, and of the tumble.toml that builds its engine; of
/// the error in place of what cannot be read, which the case's own run reports. HISTORY.md decides no verdict and is
/// not part of it.
std::string suite_hash(const Suite& suite);

/// Of names in their order.
std::string names_hash(const std::vector<std::string>& names);

}  // namespace tumble::golden
