#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

namespace tumble::replay {

/// The value of a field in which two sessions may differ: a double, an integer, text (hashes, names), or nothing, where
/// a session does not have the body (JSON: null).
using FieldValue = std::variant<double, std::uint64_t, std::string, std::monostate>;

std::string to_string(const FieldValue& value);  ///< doubles with 17 digits; nothing is "not there"

/// Equality of every bit: a NaN equals itself, −0.0 and 0.0 differ.
bool same_bits(const FieldValue& a, const FieldValue& b);

/// The number of steps from one double to the other through all doubles between; −0.0 and 0.0 are one apart. None for
/// NaN.
std::optional<std::uint64_t> ulps_between(double a, double b);

/// ulps_between() for the floats nearest to the two doubles; of two doubles nearest to one float, that of the doubles,
/// so that what differs is never 0 apart. None for NaN and for values beyond the range of a float.
std::optional<std::uint64_t> ulps32_between(double a, double b);

}  // namespace tumble::replay
