// Who may include whom: the table of rooms.cc, and circles that no table of folders shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "tests/support/source_tree.h"
#include "tests/tree/includes.h"
#include "tests/tree/rooms.h"

namespace tumble::test {
namespace {

bool exists(const std::string& path) {
  return std::filesystem::exists(std::filesystem::path(TUMBLE_SOURCE_DIR) / path);
}

std::set<std::string> folders_with_code() {
  std::set<std::string> folders;
  for (const SourceFile& file : source_tree()) {
    if (file.is_code()) folders.insert(folder_of(file.path));
  }
  return folders;
}

TEST(Layers, EveryFolderWithCodeHasARow) {
  for (const std::string& folder : folders_with_code()) {
    EXPECT_NE(room_of(folder + "/"), nullptr) << folder << ": give the folder a row in tests/tree/rooms.cc";
  }
}

TEST(Layers, EveryRowIsAFolderAndNamesOnlyRowsAboveIt) {
  std::set<std::string_view> above;
  for (const Room& room : rooms()) {
    EXPECT_TRUE(exists(std::string(room.folder))) << room.folder << " has a row and does not exist";
    for (const std::string_view folder : room.may_include) {
      EXPECT_TRUE(folder == "*" || above.contains(folder))
          << room.folder << " may include " << folder << ", which has no row above it: the table itself would climb";
    }
    EXPECT_TRUE(above.insert(room.folder).second) << room.folder << " has two rows";
  }
}

TEST(Layers, NoIncludeClimbs) {
  const std::vector<Include> includes = includes_of(source_tree());
  for (const Include& include : includes) {
    const Room* room = room_of(include.from);
    if (room == nullptr) continue;  // EveryFolderWithCodeHasARow tells
    EXPECT_TRUE(may_include(*room, folder_of(include.file)))
        << include.from << ':' << include.line << ": code of " << room->folder << " must not include " << include.file;
  }
  EXPECT_GT(includes.size(), 500U) << "the test saw hardly any includes, so it proves nothing";
}

TEST(Layers, EveryIncludedFileExists) {
  for (const Include& include : includes_of(source_tree())) {
    EXPECT_TRUE(exists(include.file) || include.file.ends_with(".capnp.h"))
        << include.from << ':' << include.line << ": found no " << include.file
        << "; includes are written from the repository root, or as cmake/public_headers.txt spells them";
  }
}

TEST(Layers, NoCircleBetweenUnits) {
  for (const std::string& circle : circles(includes_of(source_tree()))) ADD_FAILURE() << "a circle: " << circle;
}

SourceFile made_up(const std::string& path, std::vector<std::string> lines) {
  return {.path = path, .lines = std::move(lines), .executable = false};
}

// Two headers that are no circle are one if a source includes back: units, not files, are looked at.
TEST(Layers, CircleThroughASourceIsFound) {
  const std::vector<SourceFile> files = {
      made_up("src/step/a.h", {"#include \"src/step/b.h\""}),
      made_up("src/step/b.cc", {"#include \"src/step/b.h\"", "#include \"src/step/c.h\""}),
      made_up("src/step/c.h", {"#include \"src/step/a.h\""}), made_up("src/step/d.h", {"#include \"src/step/a.h\""})};
  EXPECT_EQ(circles(includes_of(files)),
            std::vector<std::string>{"src/step/a.h includes src/step/b.h, src/step/b.cc includes src/step/c.h, "
                                     "src/step/c.h includes src/step/a.h"});
}

TEST(Layers, RoomsBesideOneAnotherStayApart) {
  const Room* thesis = room_of("src/thesis/any.cc");
  const Room* solve = room_of("src/layered/solve/any.cc");
  ASSERT_TRUE(thesis != nullptr && solve != nullptr);
  EXPECT_TRUE(may_include(*thesis, "src/collide"));
  EXPECT_FALSE(may_include(*thesis, "src/layered/solve"));
  EXPECT_FALSE(may_include(*solve, "src/thesis"));
  EXPECT_FALSE(may_include(*solve, "src/step"));
}

}  // namespace
}  // namespace tumble::test
