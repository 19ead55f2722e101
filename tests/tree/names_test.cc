// Two types of one name in one namespace: each file compiles, and the linker takes one's functions for the other.
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <string>
#include <vector>

#include "tests/support/source_tree.h"

namespace tumble::test {
namespace {

/// The types that a file defines outside anonymous namespaces and outside other types, which are indented.
std::vector<std::string> types_of(const SourceFile& file) {
  static const std::regex opens(R"((?:inline )?namespace ?([\w:]*) ?\{)");
  static const std::regex defines(
      R"((?:struct|class|enum class|enum)(?: alignas\(.*\))? (\w+)(?: final| :[^:].*)? \{.*)");
  std::vector<std::string> names, types;
  for (const std::string& line : file.lines) {
    std::smatch found;
    if (std::regex_match(line, found, opens)) names.push_back(found[1]);
    if (line.starts_with("}  // namespace") && !names.empty()) names.pop_back();
    if (!std::regex_match(line, found, defines)) continue;
    std::string type;
    for (const std::string& name : names) type += name.empty() ? "(anonymous)" : name + "::";
    if (type.find("(anonymous)") == std::string::npos) types.push_back(type + found[1].str());
  }
  return types;
}

TEST(Names, ATypeIsDefinedOnce) {
  std::map<std::string, std::string> places;
  for (const SourceFile& file : source_tree()) {
    if (!file.is_code() || file.is_under("tests/") || file.is_under("examples/")) continue;
    for (const std::string& type : types_of(file)) {
      const auto [place, first] = places.emplace(type, file.path);
      EXPECT_TRUE(first) << type << " is defined in " << place->second << " and in " << file.path
                         << ": name one of them otherwise, or put it into an anonymous namespace";
    }
  }
  EXPECT_GT(places.size(), 300U) << "the test saw hardly any types, so it proves nothing";
}

}  // namespace
}  // namespace tumble::test
