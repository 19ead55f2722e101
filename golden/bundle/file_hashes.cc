#include "golden/bundle/file_hashes.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>

#include "golden/engine/project.h"
#include "tumble/sim/hash.h"

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPiece = std::size_t{1} << 20;

void add_text(Hasher& hasher, std::string_view text) {
  hasher.add(static_cast<std::uint64_t>(text.size()));
  hasher.add(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

Status add_content(Hasher& hasher, const fs::path& path, std::uint64_t& bytes) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::vector<std::uint8_t> piece(kPiece);
  std::error_code error;
  if (!file || fs::is_directory(path, error)) {
    return bad_input(path.string() + ": cannot be read: " + (errno == 0 ? "is no file" : std::strerror(errno)));
  }
  while (file) {
    file.read(reinterpret_cast<char*>(piece.data()), static_cast<std::streamsize>(piece.size()));
    const auto count = static_cast<std::size_t>(file.gcount());
    hasher.add(std::span(piece.data(), count));
    bytes += count;
  }
  return file.bad() ? Status(cannot_finish(path.string() + ": cannot be read: " + std::strerror(errno))) : Status();
}

/// All files below, in order; links to folders are not followed. error: why the folder could not be listed, or empty.
std::vector<fs::path> files_below(const fs::path& folder, std::string& error) {
  std::vector<fs::path> files;
  std::error_code code;
  for (fs::recursive_directory_iterator at(folder, code), end; !code && at != end; at.increment(code)) {
    std::error_code ignored;
    if (!at->is_directory(ignored)) files.push_back(at->path());
  }
  if (code) error = code.message();
  std::ranges::sort(files);
  return files;
}

void add_file(Hasher& hasher, const fs::path& file) {
  std::uint64_t bytes = 0;
  std::error_code error;
  if (!fs::is_regular_file(file, error)) {
    add_text(hasher, "no file");  // a pipe would be waited for
  } else if (Status ok = add_content(hasher, file, bytes); !ok.ok()) {
    add_text(hasher, ok.error().message);
  }
  hasher.add(bytes);
}

}  // namespace

Result<FileHash> hash_file(const fs::path& path) {
  Hasher hasher;
  FileHash found;
  if (Status ok = add_content(hasher, path, found.bytes); !ok.ok()) return ok.error();
  found.hash = to_string(hasher.digest());
  return found;
}

std::string program_hash() {
  const Result<FileHash> found = hash_file("/proc/self/exe");
  return found.ok() ? found->hash : "not known";
}

std::string suite_hash(const Suite& suite) {
  Hasher hasher;
  for (const CaseFolder& one : suite.cases) {
    std::string error;
    for (const fs::path& file : files_below(one.path, error)) {
      add_text(hasher, file.lexically_relative(suite.root).string());
      add_file(hasher, file);
    }
    add_text(hasher, error);
  }
  // A project that cannot be read is an error of the check.
  const Result<std::optional<EngineProject>> project = find_project(suite.root);
  if (project.ok() && *project) add_file(hasher, (*project)->file);
  return to_string(hasher.digest());
}

std::string names_hash(const std::vector<std::string>& names) {
  Hasher hasher;
  for (const std::string& name : names) add_text(hasher, name);
  return to_string(hasher.digest());
}

}  // namespace tumble::golden
