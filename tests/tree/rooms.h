#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tumble::test {

/// A folder with code and the folders that its code may include. A folder always includes itself.
struct Room {
  std::string_view folder;                    ///< from the repository root, without closing '/'
  std::vector<std::string_view> may_include;  ///< folders with rows further up; "*" for all of them
};

/// The table of all folders with code, lowest first. Folders inside a folder have rows of their own.
const std::vector<Room>& rooms();

/// The row of a file's folder; null if the table has none.
const Room* room_of(const std::string& path);

/// Whether code of a room may include a file of that folder.
bool may_include(const Room& room, std::string_view folder);

/// The folder of a path: "src/step" of "src/step/step.h"; empty at the repository root.
std::string folder_of(const std::string& path);

}  // namespace tumble::test
