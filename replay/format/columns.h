#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "replay/format/step_record.h"

namespace tumble::replay {

/// The columns of doubles of BodyStates in one list, in the order of log.capnp's States.columns.
enum ColumnIndex : std::size_t { kVelocity = 0, kSpin = 3, kPosition = 6, kOrientation = 9, kColumnCount = 13 };

using Columns = std::array<std::vector<double>*, kColumnCount>;
using ConstColumns = std::array<const std::vector<double>*, kColumnCount>;

inline Columns columns_of(BodyStates& s) {
  return {&s.velocity.x,    &s.velocity.y,    &s.velocity.z,   &s.spin.x,     &s.spin.y,
          &s.spin.z,        &s.position.x,    &s.position.y,   &s.position.z, &s.orientation.w,
          &s.orientation.x, &s.orientation.y, &s.orientation.z};
}

inline ConstColumns columns_of(const BodyStates& s) {
  return {&s.velocity.x,    &s.velocity.y,    &s.velocity.z,   &s.spin.x,     &s.spin.y,
          &s.spin.z,        &s.position.x,    &s.position.y,   &s.position.z, &s.orientation.w,
          &s.orientation.x, &s.orientation.y, &s.orientation.z};
}

/// "velocity.x", …: what reports call a column.
inline constexpr std::array<const char*, kColumnCount> kColumnNames = {
    "velocity.x", "velocity.y", "velocity.z",    "spin.x",        "spin.y",        "spin.z",       "position.x",
    "position.y", "position.z", "orientation.w", "orientation.x", "orientation.y", "orientation.z"};

}  // namespace tumble::replay
