#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "replay/arrays/npy.h"

/// Arrays as the text of a table.
namespace tumble::replay {

/// "(40, 3)".
std::string shape_text(const std::vector<std::size_t>& shape);

/// Null where no array has this name.
const Array* find_array(const std::vector<Array>& arrays, std::string_view name);

/// Whether a cell is true: of numpy's bool, or a number.
bool is_true(const std::string& cell);

/// Whether an array can be a unit: one text that the name of a column may have.
bool is_unit(const Array& array);

/// The unit of an array behind a column's name, " (rad)": that of the scalar unit.NAME; empty where there is none.
/// Precondition: is_unit().
std::string unit_behind(const std::vector<Array>& arrays, const Array& array);

/// Steps at the start and at the end in which no body is present, and which a table has no rows for: for messages.
std::vector<std::string> bodiless_ends(const Array& present);

/// What bodiless_ends() says, and two arrays of one meaning, of which the first name that is known is read.
std::vector<std::string> odd_parts(const std::vector<Array>& arrays, const Array* present);

/// Stands in for a text that has no character and is there: no text of numpy's ends with a zero.
inline const std::string kEmptyText(1, '\0');

/// A column of the table: its name, and the cell of a step and a body.
struct TableColumn {
  std::string name;
  std::function<std::string(std::size_t step, std::size_t body)> cell;
};

/// A part of an array as a column: of (steps), (steps, n), (steps, bodies) or (steps, bodies, n).
struct ChannelPart {
  const Array* values = nullptr;
  const Array* present = nullptr;  ///< likewise true where there is a value; null: everywhere
  const Array* texts = nullptr;    ///< the values are numbers of its rows; null: they are values
  bool of_bodies = false;
  bool many = false;
  std::size_t part = 0;

  /// Empty: no value; kEmptyText: a text without a character.
  [[nodiscard]] std::string cell(std::size_t step, std::size_t body) const;
  /// The word for `import`: "float64", "float32", "int64", "uint64", "text".
  [[nodiscard]] const char* kind() const;
};

/// The line of the header that a scalar stands for, or three numbers of a key that has three: "# gravity: 0 0 -9.81"
/// and a line end. Empty for another array.
std::string header_line(const Array& array);

/// "# kinds: float64 text" and a line end; empty where some channel among the columns has no kind.
std::string kinds_line(const std::vector<TableColumn>& columns, const std::vector<std::string>& kinds);

/// The lines of the table: kRowsOfArrays, `header`, the names, a row a step and body. Names and cells are as
/// text_cell() writes them, and the header says so where that changes any. present: (steps, bodies), false where the
/// table has no row; null: rows everywhere.
std::string print_rows(const std::string& header, const std::vector<TableColumn>& columns, std::size_t steps,
                       std::size_t bodies, const Array* present);

}  // namespace tumble::replay
