#include "tests/support/source_tree.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <numeric>

namespace tumble::test {
namespace {

namespace fs = std::filesystem;

constexpr std::array kFolders = {".ci",    "bench",  "cmake", "docs",  "golden", "python",
                                 "replay", "schema", "src",   "tests", "tools"};
constexpr std::array kBinary = {".png", ".tumble", ".mp4", ".orig", ".bin", ".npz"};

SourceFile read(const fs::path& root, const fs::path& path) {
  SourceFile file;
  file.path = fs::relative(path, root).generic_string();
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) file.lines.push_back(line);
  file.executable = (fs::status(path).permissions() & fs::perms::owner_exec) != fs::perms::none;
  return file;
}

// .git is a file where the tree is a worktree of another clone.
bool is_text(const fs::path& path) {
  return path.filename() != ".git" && std::ranges::find(kBinary, path.extension().string()) == kBinary.end();
}

std::vector<SourceFile> read_tree() {
  const fs::path root = TUMBLE_SOURCE_DIR;
  std::vector<SourceFile> files;
  for (const char* folder : kFolders) {
    if (!fs::is_directory(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.is_regular_file() && is_text(entry.path())) files.push_back(read(root, entry.path()));
    }
  }
  for (const auto& entry : fs::directory_iterator(root)) {
    if (entry.is_regular_file() && is_text(entry.path())) files.push_back(read(root, entry.path()));
  }
  std::ranges::sort(files, {}, &SourceFile::path);
  return files;
}

// Blanks one line; what a block comment leaves open is carried to the next.
std::string blank(std::string_view line, bool& in_comment) {
  std::string out(line.size(), ' ');
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::string_view two = line.substr(i, 2);
    if (in_comment) {
      if (two == "*/") in_comment = false, ++i;
    } else if (quote != 0) {
      if (line[i] == '\\') {
        ++i;
      } else if (line[i] == quote) {
        quote = 0;
      }
    } else if (two == "//") {
      break;
    } else if (two == "/*") {
      in_comment = true;
      ++i;
    } else if (line[i] == '"' ||
               (line[i] == '\'' && (i == 0 || std::isalnum(static_cast<unsigned char>(line[i - 1])) == 0))) {
      quote = line[i];
    } else {
      out[i] = line[i];
    }
  }
  return out;
}

}  // namespace

bool SourceFile::is_under(std::string_view folder) const { return path.starts_with(folder); }
bool SourceFile::ends_with(std::string_view suffix) const { return path.ends_with(suffix); }

std::string SourceFile::text() const {
  return std::accumulate(lines.begin(), lines.end(), std::string(),
                         [](std::string all, const std::string& line) { return std::move(all) + line + '\n'; });
}

const std::vector<SourceFile>& source_tree() {
  static const std::vector<SourceFile> files = read_tree();
  return files;
}

std::vector<std::string> without_comments_and_strings(const std::vector<std::string>& lines) {
  std::vector<std::string> code;
  code.reserve(lines.size());
  bool in_comment = false;
  for (const std::string& line : lines) {
    code.push_back(line.starts_with("#include") ? line : blank(line, in_comment));
  }
  return code;
}

}  // namespace tumble::test
