// Build lists name every source, and every folder with code has one.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "tests/support/source_tree.h"
#include "tests/tree/rooms.h"

namespace tumble::test {
namespace {

TEST(Lists, EverySourceFileIsInItsFoldersBuildList) {
  std::map<std::string, std::string> lists;
  for (const SourceFile& file : source_tree()) {
    if (!file.ends_with("CMakeLists.txt")) continue;
    std::string text = " ";
    for (const std::string& line : file.lines) text += line.substr(0, line.find('#')) + ' ';
    lists[file.path.substr(0, file.path.size() - std::string("CMakeLists.txt").size())] = text;
  }
  for (const SourceFile& file : source_tree()) {
    if (!file.ends_with(".cc")) continue;
    std::string folder = file.path;
    do {
      folder.resize(folder.find_last_of('/', folder.size() - 2) + 1);
    } while (!folder.empty() && !lists.contains(folder));
    const std::regex listed("[ (]" + std::regex_replace(file.path.substr(folder.size()), std::regex("\\."), "\\.") +
                            "[ )]");
    EXPECT_TRUE(std::regex_search(lists[folder], listed)) << file.path << " is not in " << folder << "CMakeLists.txt";
  }
}

TEST(Lists, EveryFolderWithCodeHasABuildList) {
  std::set<std::string> listed;
  for (const SourceFile& file : source_tree()) {
    if (file.ends_with("/CMakeLists.txt")) listed.insert(folder_of(file.path));
  }
  for (const Room& room : rooms()) {
    if (room.folder == "schema") continue;  // its code is generated in replay/
    EXPECT_TRUE(listed.contains(std::string(room.folder))) << room.folder << " has no CMakeLists.txt";
  }
}

TEST(Lists, HeadersAreGuardedOnce) {
  for (const SourceFile& file : source_tree()) {
    if (!file.ends_with(".h")) continue;
    EXPECT_EQ(std::ranges::count(file.lines, "#pragma once"), 1) << file.path;
  }
}

}  // namespace
}  // namespace tumble::test
