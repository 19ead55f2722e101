#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The cell of a column pair.NAME of a table: values of pairs, "7=0.25 9=0.5", in the row of the first body of each.
namespace tumble::replay {

struct PairCell {
  std::uint64_t other = 0;  ///< the second body
  std::string_view value;   ///< as it is written; in the cell that was split
};

/// The values of a cell; none where an entry is not written as ID=VALUE.
std::optional<std::vector<PairCell>> split_pair_cell(std::string_view cell);

/// Text within an entry: spaces, commas, '%' and control characters as %20 and the like; and back.
std::string escaped_cell(std::string_view text);
std::string unescaped_cell(std::string_view text);

/// Any text as a whole cell of a table with the line kEscapesLine: commas, '%', control characters and blanks at the
/// ends as %2c and the like, and "%" for a text without a character; and back.
std::string text_cell(std::string_view text);
std::string text_in_cell(std::string_view cell);

inline constexpr std::string_view kEscapesKey = "escapes", kEscapesValue = "percent";
inline constexpr std::string_view kEscapesLine = "# escapes: percent\n";

/// The first line of a table that was made of arrays: messages then name step and body, for no file has its lines.
inline constexpr std::string_view kRowsOfArrays = "# rows of arrays";

/// Reads back to the same bits. Readers of tables know "inf" and the usual "nan".
std::string number_cell(double number);

}  // namespace tumble::replay
