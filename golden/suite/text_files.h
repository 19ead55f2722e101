#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/sim/result.h"

/// Small files, whole.
namespace tumble::golden {

/// Errors (kBadInput): missing, a folder, no permission, larger than anything a suite holds. kCannotFinish: the disk
/// gives fewer bytes than the file has.
Result<std::string> read_text(const std::filesystem::path& path);
/// As read_text(), of the table or archive that an engine wrote, which may be as large as `tumble import` takes.
Result<std::string> read_table(const std::filesystem::path& path);
Result<std::vector<std::byte>> read_bytes(const std::filesystem::path& path);

/// Writes beside the file and renames, so that a crash leaves the old one. Folders are made. Errors. kBadInput: a
/// folder, no permission. kCannotFinish: the disk.
Status write_file(const std::filesystem::path& path, std::string_view content);
Status write_file(const std::filesystem::path& path, std::span<const std::byte> content);

/// Without the ends of lines.
std::vector<std::string> lines_of(std::string_view text);

}  // namespace tumble::golden
