#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "tumble/replay/body_states.h"
#include "tumble/replay/imported_table.h"
#include "tumble/sim/ids.h"

/// Bodies whose state is no state: not a number, or infinite, in any field. Every command asks here, so that no sum,
/// maximum or comparison meets such a number unnoticed.
namespace tumble::replay {

/// A body that is lost because a field of its state is not finite.
struct NotFinite {
  sim::BodyId body = 0;
  std::uint64_t step = 0;    ///< the first with such a field
  const char* field = "";    ///< of kColumnNames: "position.x"
  double value = 0;          ///< NaN or infinite
  std::uint64_t bodies = 1;  ///< lost so by now, this one included
};

/// The field by its name in the table, and the value with the table's sign.
NotFinite in_axes(const EngineAxes& axes, NotFinite lost);

/// "body 7 is lost from step 12 on: position.x is nan", and the number of further bodies. axes: of the log; the field
/// is named by them.
std::string to_string(const NotFinite& lost, const EngineAxes& axes);

/// Whether all fields of all bodies are finite. Costs a pass over 13 columns.
bool all_finite(const BodyStates& states);

/// Whether all fields of one body are finite.
bool is_finite(const BodyStates& states, std::size_t row);

/// The first field of a body that is not finite, in the order position, orientation, velocity, spin; none if all are.
std::optional<NotFinite> not_finite(const BodyStates& states, std::size_t row, std::uint64_t step);

/// That of the first body, by id, that has one, with the number of all such bodies; none if every body is finite.
std::optional<NotFinite> first_not_finite(const BodyStates& states, std::uint64_t step);

inline constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

// std::max and std::min drop a NaN, std::min(1.0, NaN) is 1. These keep it, in either argument.
inline double largest(double a, double b) { return a >= b || a != a ? a : b; }
inline double least(double a, double b) { return a <= b || a != a ? a : b; }

}  // namespace tumble::replay
