#pragma once

#include <optional>
#include <string_view>

#include "tumble/replay/imported_table.h"

namespace tumble::replay {

/// A column of body states as a table of another engine has it.
struct EngineColumn {
  const char* name = "";   ///< of kColumnNames, with the table's axis: "position.z"
  double sign = 1;         ///< −1: the table's axis points the other way
  bool is_length = false;  ///< in the table's unit of length, or that per second
};

/// The table's column that holds the numbers of ours. field: of kColumnNames, "position.y"; none for any other field.
std::optional<EngineColumn> column_in(const EngineAxes& axes, std::string_view field);

}  // namespace tumble::replay
