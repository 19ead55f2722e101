// Two types of one name in one namespace: each file compiles, and the linker takes one's functions for the other.
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <string>
#include <vector>

#include "tests/support/source_tree.h"

namespace tumble::test {
namespace {

constexpr const char* kAnonymous = "(anonymous)";

/// Calls visit(namespaces, name) for what a file defines outside types, which are indented. The name is the first group
/// of the expression; of an anonymous namespace kAnonymous stands among the namespaces, "tumble::(anonymous)".
template <class Visit>
void for_definitions(const SourceFile& file, const std::regex& defines, Visit visit) {
  static const std::regex opens(R"((?:inline )?namespace ?([\w:]*) ?\{)");
  std::vector<std::string> names;
  for (const std::string& line : file.lines) {
    std::smatch found;
    if (std::regex_match(line, found, opens)) names.push_back(found[1]);
    if (line.starts_with("}  // namespace") && !names.empty()) names.pop_back();
    if (!std::regex_match(line, found, defines)) continue;
    std::string inside;
    for (const std::string& name : names) inside += name.empty() ? kAnonymous : name + "::";
    visit(inside, found[1].str());
  }
}

std::vector<std::string> types_of(const SourceFile& file) {
  static const std::regex defines(
      R"((?:struct|class|enum class|enum)(?: alignas\(.*\))? (\w+)(?: final| :[^:].*)? \{.*)");
  std::vector<std::string> types;
  for_definitions(file, defines, [&](const std::string& inside, const std::string& name) {
    if (inside.find(kAnonymous) == std::string::npos) types.push_back(inside + name);
  });
  return types;
}

const std::regex& constant() {
  static const std::regex defines(R"((?:inline |static )?const(?:expr)? [\w:<>, *]*?\b(k[A-Z]\w*)\b.*)");
  return defines;
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

// Where a folder is compiled as one unit, a file's own constant hides that of a header in all files behind it.
TEST(Names, NoConstantOfAFileHidesThatOfAHeader) {
  std::map<std::string, std::string> of_headers;
  const std::vector<SourceFile>& tree = source_tree();
  const auto looked_at = [](const SourceFile& file) {
    return file.is_code() && !file.is_under("tests/") && !file.is_under("examples/") && !file.is_under("bench/");
  };
  for (const SourceFile& file : tree) {
    if (!looked_at(file) || !file.path.ends_with(".h")) continue;
    for_definitions(file, constant(), [&](const std::string& inside, const std::string& name) {
      of_headers.emplace(inside + name, file.path);
    });
  }
  for (const SourceFile& file : tree) {
    if (!looked_at(file) || file.path.ends_with(".h")) continue;
    for_definitions(file, constant(), [&](std::string inside, const std::string& name) {
      const std::size_t at = inside.find(kAnonymous);
      if (at == std::string::npos) return;
      const auto hidden = of_headers.find(inside.erase(at) + name);
      if (hidden == of_headers.end()) return;
      ADD_FAILURE() << name << " of " << file.path << " hides that of " << hidden->second << ": name it otherwise";
    });
  }
  EXPECT_GT(of_headers.size(), 100U) << "the test saw hardly any constants, so it proves nothing";
}

}  // namespace
}  // namespace tumble::test
