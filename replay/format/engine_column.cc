#include "replay/format/engine_column.h"

#include <algorithm>
#include <cstddef>

#include "tumble/replay/body_states.h"

namespace tumble::replay {

std::optional<EngineColumn> column_in(const EngineAxes& axes, std::string_view field) {
  const auto* const found = std::ranges::find(kColumnNames, field);
  if (found == kColumnNames.end()) return std::nullopt;
  const bool is_length = field.starts_with("position") || field.starts_with("velocity");
  if (field == "orientation.w") return EngineColumn{*found, 1, false};
  const int k = field.back() - 'x';
  const EngineAxis axis = is_length ? axes.along(k) : axes.axial_along(k);
  return EngineColumn{*(found + (axis.letter - 'x' - k)), axis.sign, is_length};
}

}  // namespace tumble::replay
