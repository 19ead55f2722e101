#include "replay/format/not_finite.h"

#include <algorithm>
#include <array>

#include "replay/format/engine_column.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

/// x · 0 is 0 for a finite x of either sign, and NaN for all others; a sum of zeros stays 0.
bool all_finite(const std::vector<double>& column) {
  constexpr std::size_t kLanes = 4;  // sums that do not wait for one another
  std::array<double, kLanes> sums = {};
  const std::size_t whole = column.size() - column.size() % kLanes;
  for (std::size_t i = 0; i < whole; i += kLanes) {
    for (std::size_t k = 0; k < kLanes; ++k) sums[k] += column[i + k] * 0.0;
  }
  for (std::size_t i = whole; i < column.size(); ++i) sums[0] += column[i] * 0.0;
  return (sums[0] + sums[1]) + (sums[2] + sums[3]) == 0;
}

}  // namespace

NotFinite in_axes(const EngineAxes& axes, NotFinite lost) {
  const std::optional<EngineColumn> column = column_in(axes, lost.field);
  if (!column) return lost;
  lost.field = *std::ranges::find(kColumnNames, column->name);
  if (column->sign < 0) lost.value = -lost.value;
  return lost;
}

std::string to_string(const NotFinite& lost, const EngineAxes& axes) {
  const NotFinite named = in_axes(axes, lost);
  std::string text = "body " + std::to_string(named.body) + " is lost from step " + std::to_string(named.step) +
                     " on: " + named.field + " is " + exact(named.value);
  if (named.bodies > 1) text += ", and " + count_text(named.bodies - 1, "body") + " more likewise";
  return text;
}

bool all_finite(const BodyStates& states) {
  for (const std::vector<double>* column : columns_of(states)) {
    if (!all_finite(*column)) return false;
  }
  return true;
}

bool is_finite(const BodyStates& states, std::size_t row) {
  double sum = 0;
  for (const std::vector<double>* column : columns_of(states)) sum += (*column)[row] * 0.0;
  return sum == 0;
}

std::optional<NotFinite> not_finite(const BodyStates& states, std::size_t row, std::uint64_t step) {
  const ConstColumns columns = columns_of(states);
  for (const std::size_t k : kFieldOrder) {
    const double value = (*columns[k])[row];
    if (!std::isfinite(value)) return NotFinite{states.id[row], step, kColumnNames[k], value, 1};
  }
  return std::nullopt;
}

std::optional<NotFinite> first_not_finite(const BodyStates& states, std::uint64_t step) {
  if (all_finite(states)) return std::nullopt;
  std::optional<NotFinite> first;
  std::uint64_t bodies = 0;
  for (std::size_t row = 0; row < states.size(); ++row) {
    if (is_finite(states, row)) continue;
    ++bodies;
    if (!first) first = not_finite(states, row, step);
  }
  if (first) first->bodies = bodies;
  return first;
}

}  // namespace tumble::replay
