#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tumble/replay/imported_table.h"

namespace tumble::replay {

/// A number as a table of another engine has it: the one place that knows how a field is named in the axes of a table.
struct EngineColumn {
  std::string name;        ///< the field with the table's axis: "position.z"
  double sign = 1;         ///< −1: the table's axis points the other way
  bool is_length = false;  ///< in the table's unit of length, or that per second
};

/// The table's name for a field of ours: a column of states ("position.y"), a number of a contact ("contact.normal.z",
/// "contact.depth"), of an input ("throw.velocity.x", "push.at.y") or a parameter ("world.gravity.z", "body 7 size.y").
/// None for any other field.
std::optional<EngineColumn> column_in(const EngineAxes& axes, std::string_view field);

}  // namespace tumble::replay
