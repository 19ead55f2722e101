#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tumble::test {

/// A text file of this repository.
struct SourceFile {
  std::string path;  ///< from the repository root, with '/'
  std::vector<std::string> lines;
  bool executable = false;

  [[nodiscard]] bool is_under(std::string_view folder) const;  ///< folder with its closing '/'
  [[nodiscard]] bool ends_with(std::string_view suffix) const;
  [[nodiscard]] bool is_code() const { return ends_with(".cc") || ends_with(".h"); }
  [[nodiscard]] std::string text() const;
};

/// The project's own text files, ascending by path: what is in the known folders and beside CMakeLists.txt; build
/// folders, logs and pictures are left out. Needs no git, so that it holds for a tarball too.
const std::vector<SourceFile>& source_tree();

/// Code with comments and string literals blanked out, line by line.
std::vector<std::string> without_comments_and_strings(const std::vector<std::string>& lines);

}  // namespace tumble::test
