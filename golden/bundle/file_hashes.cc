#include "golden/bundle/file_hashes.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>

#include "src/process/split_words.h"
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

/// The file that a word of a command names: a path from the folder, and for the program itself also a name in PATH.
/// Empty: none.
fs::path file_of_word(const std::string& word, const fs::path& folder, bool is_program) {
  std::error_code error;
  if (fs::is_regular_file(folder / word, error)) return folder / word;
  const char* path = std::getenv("PATH");
  if (!is_program || path == nullptr || word.find('/') != std::string::npos) return {};
  std::string_view left = path;
  while (!left.empty()) {
    const std::size_t end = std::min(left.find(':'), left.size());
    fs::path file = fs::path(left.substr(0, end)) / word;
    if (fs::is_regular_file(file, error)) return file;
    left.remove_prefix(std::min(end + 1, left.size()));
  }
  return {};
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

std::string program_hash(const std::string& program) {
  const Result<FileHash> found = hash_file(file_of_word(program, fs::current_path(), true));
  return found.ok() ? found->hash : "not known";
}

std::string engine_hash(const EngineProject& project) {
  const Result<std::vector<std::string>> words = process::split_words(project.run);
  Hasher hasher;
  bool any = false;
  for (std::size_t k = 0; words.ok() && k < words->size(); ++k) {
    const fs::path file = file_of_word((*words)[k], project.folder, k == 0);
    if (file.empty()) continue;
    any = true;
    add_text(hasher, (*words)[k]);
    add_file(hasher, file);
  }
  add_text(hasher, kIntegratorNames[static_cast<std::size_t>(project.integrator)]);
  hasher.add(project.substeps);
  return any ? to_string(hasher.digest()) : "not known";
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
