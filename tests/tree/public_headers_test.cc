// The table of public headers, and that code spells them as programs outside this tree will.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <string>

#include "tests/support/source_tree.h"
#include "tests/tree/includes.h"

namespace tumble::test {
namespace {

// The spelling of a public header by its file.
std::map<std::string, std::string> spellings() {
  std::map<std::string, std::string> by_file;
  for (const auto& [spelled, file] : public_headers()) by_file.emplace(file, spelled);
  return by_file;
}

TEST(PublicHeaders, EveryRowIsAFileOfTheSameName) {
  EXPECT_GE(public_headers().size(), 20U) << "the test saw hardly any rows, so it proves nothing";
  for (const auto& [spelled, file] : public_headers()) {
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(TUMBLE_SOURCE_DIR) / file))
        << "cmake/public_headers.txt: found no " << file;
    EXPECT_EQ(spelled.substr(spelled.find_last_of('/')), file.substr(file.find_last_of('/'))) << spelled;
  }
  EXPECT_EQ(spellings().size(), public_headers().size()) << "a file has two spellings";
}

TEST(PublicHeaders, CodeSpellsThemAsUsersDo) {
  const std::map<std::string, std::string> by_file = spellings();
  for (const Include& include : includes_of(source_tree())) {
    const auto found = by_file.find(include.spelled);
    EXPECT_TRUE(found == by_file.end()) << include.from << ':' << include.line << ": write \"" << found->second
                                        << "\" instead of " << include.spelled;
  }
}

TEST(PublicHeaders, TheyIncludeOnlyPublicHeaders) {
  const std::map<std::string, std::string> by_file = spellings();
  for (const Include& include : includes_of(source_tree())) {
    if (!by_file.contains(include.from)) continue;
    EXPECT_TRUE(by_file.contains(include.file)) << include.from << " is public and includes " << include.file
                                                << ", which cmake/public_headers.txt does not list";
  }
}

TEST(PublicHeaders, TheyIncludeNoLibraryButEigen) {
  const std::regex system("^#include <([^>]+)>");
  const std::regex known("[a-z_0-9]+|std(int|def)\\.h|Eigen/.*");
  const std::map<std::string, std::string> by_file = spellings();
  for (const SourceFile& file : source_tree()) {
    if (!by_file.contains(file.path)) continue;
    for (const std::string& line : file.lines) {
      std::smatch match;
      if (!std::regex_search(line, match, system)) continue;
      const std::string header = match[1];
      EXPECT_TRUE(std::regex_match(header, known)) << file.path << " is public and includes <" << header << '>';
    }
  }
}

}  // namespace
}  // namespace tumble::test
