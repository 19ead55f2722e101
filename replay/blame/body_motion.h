#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tumble/replay/body_states.h"
#include "tumble/sim/rotation.h"
#include "tumble/sim/vec.h"

/// One body's visible values, by the names and in the order of kColumnNames, then "frozen".
namespace tumble::replay {

inline constexpr std::size_t kFrozenField = kColumnCount;
inline constexpr std::size_t kNoField = kColumnCount + 1;

struct BodyMotion {
  std::array<double, kColumnCount + 1> values = {};

  [[nodiscard]] double of(std::size_t field) const { return values[field]; }
  [[nodiscard]] sim::Vec3 vector(std::size_t first) const {
    return {values[first], values[first + 1], values[first + 2]};
  }
  void set(std::size_t first, const sim::Vec3& v) {
    for (int k = 0; k < 3; ++k) values[first + static_cast<std::size_t>(k)] = v[k];
  }
  [[nodiscard]] bool frozen() const { return values[kFrozenField] != 0; }
};

/// Of sim::Bodies or BodyStates, row i.
template <class States>
BodyMotion motion_of(const States& states, std::size_t i) {
  BodyMotion motion;
  const ConstColumns columns = columns_of(states);
  for (std::size_t k = 0; k < kColumnCount; ++k) motion.values[k] = (*columns[k])[i];
  motion.values[kFrozenField] = states.frozen[i];
  return motion;
}

inline bool same_value(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// kNoField for any other text.
inline std::size_t field_of(const std::string& name) {
  for (std::size_t k = 0; k < kColumnCount; ++k) {
    if (name == kColumnNames[k]) return k;
  }
  return name == "frozen" ? kFrozenField : kNoField;
}
inline std::string field_name(std::size_t field) { return field < kColumnCount ? kColumnNames[field] : "frozen"; }

/// All names, in the order in which reports look through them.
inline std::vector<std::string> blame_fields() {
  std::vector<std::string> fields;
  fields.reserve(kFieldOrder.size() + 1);
  for (const std::size_t column : kFieldOrder) fields.emplace_back(kColumnNames[column]);
  fields.emplace_back("frozen");
  return fields;
}

/// The first column of the field's vector: kVelocity, kSpin, kPosition, kOrientation; kFrozenField.
inline std::size_t quantity_of(std::size_t field) {
  for (const std::size_t first : {kPosition, kSpin, kVelocity}) {
    if (field >= first && field < first + 3) return first;
  }
  return field >= kFrozenField ? kFrozenField : static_cast<std::size_t>(kOrientation);
}

inline const char* unit_of_field(std::size_t field) {
  switch (quantity_of(field)) {
    case kVelocity:
      return "m/s";
    case kSpin:
      return "rad/s";
    case kPosition:
      return "m";
    default:
      return "";
  }
}

/// The component with the largest magnitude, of the vector whose first column is `first`.
inline std::size_t largest_of(const BodyMotion& motion, std::size_t first) {
  std::size_t largest = first;
  for (std::size_t k = first; k < first + 3; ++k) {
    if (std::fabs(motion.of(k)) > std::fabs(motion.of(largest))) largest = k;
  }
  return largest;
}

}  // namespace tumble::replay
