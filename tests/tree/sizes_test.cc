// How long files get, and how many units lie in a folder.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "tests/support/source_tree.h"
#include "tests/tree/rooms.h"

namespace tumble::test {
namespace {

// Code and scripts; data, such as planted faults, scenes and the bundle that npm makes, is as long as it is.
bool has_a_limit(const SourceFile& file) {
  if (file.path == "golden/report/page/bundle.js") return false;
  if (file.path == "replay/recorder/tumble_recorder.c") return false;  // one file, so that engines copy two
  for (const char* ending : {".h", ".cc", ".c", ".sh", ".py", ".js", ".cmake", ".capnp", "CMakeLists.txt"}) {
    if (file.ends_with(ending)) return true;
  }
  return false;
}

TEST(Sizes, FilesStayShort) {
  constexpr std::size_t kLinesMax = 300;
  constexpr std::size_t kLinesLong = 250;
  constexpr double kLongShareMax = 0.1;  // a ratchet: lower it when the tree allows, never raise it
  std::size_t count = 0;
  std::size_t long_count = 0;
  std::string long_files;
  for (const SourceFile& file : source_tree()) {
    if (!has_a_limit(file)) continue;
    ++count;
    EXPECT_LE(file.lines.size(), kLinesMax) << file.path << ": split it";
    if (file.lines.size() <= kLinesLong) continue;
    ++long_count;
    long_files += "\n  " + file.path + ": " + std::to_string(file.lines.size());
  }
  EXPECT_GT(count, 200U) << "the test saw hardly any files, so it proves nothing";
  EXPECT_LE(static_cast<double>(long_count), kLongShareMax * static_cast<double>(count))
      << "too many files over " << kLinesLong << " lines:" << long_files;
}

TEST(Sizes, FoldersStaySmall) {
  constexpr std::size_t kUnitsMax = 16;
  std::map<std::string, std::set<std::string>> units;
  for (const SourceFile& file : source_tree()) {
    if (file.is_code()) units[folder_of(file.path)].insert(file.path.substr(0, file.path.find_last_of('.')));
  }
  for (const auto& [folder, names] : units) {
    if (folder == "tools/commands" || folder.starts_with("tests/")) continue;  // one unit a command, a test
    EXPECT_LE(names.size(), kUnitsMax) << folder << ": give its units rooms of their own";
  }
}

}  // namespace
}  // namespace tumble::test
