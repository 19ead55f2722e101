#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tumble/sim/hash.h"
#include "tumble/sim/world_state.h"

namespace tumble::replay {

/// The visible state of all bodies: the columns of sim::Bodies that the state hash covers, one row per body by
/// ascending id. Holds any double to the bit, also values that no world would hold.
struct BodyStates {
  std::vector<sim::BodyId> id;
  sim::Vec3Column position;          ///< m
  sim::QuatColumn orientation;       ///< w x y z
  sim::Vec3Column velocity;          ///< m/s
  sim::Vec3Column spin;              ///< rad/s
  std::vector<std::uint8_t> frozen;  ///< 0 or 1

  [[nodiscard]] std::size_t size() const { return id.size(); }
  /// Compares values: NaN differs from itself, −0.0 equals 0.0. same_bits() compares bits.
  friend bool operator==(const BodyStates&, const BodyStates&) = default;
};

/// Copies the visible columns of `bodies` into `states`, whose memory is used again.
void copy_visible(const sim::Bodies& bodies, BodyStates& states);

/// The state hash: sim::state_hash() of these columns.
Hash128 state_hash(const BodyStates& states);

/// Whether every bit is equal: NaNs with equal payload are, zeros of different sign are not.
bool same_bits(const BodyStates& a, const BodyStates& b);

/// Likewise for the visible columns of two complete states.
bool same_visible_bits(const sim::Bodies& a, const sim::Bodies& b);

/// The columns of doubles of BodyStates as one list, in the order of States.columns in log.capnp.
enum ColumnIndex : std::size_t { kVelocity = 0, kSpin = 3, kPosition = 6, kOrientation = 9, kColumnCount = 13 };

using Columns = std::array<std::vector<double>*, kColumnCount>;
using ConstColumns = std::array<const std::vector<double>*, kColumnCount>;

inline Columns columns_of(BodyStates& s) {
  return {&s.velocity.x,    &s.velocity.y,    &s.velocity.z,   &s.spin.x,     &s.spin.y,
          &s.spin.z,        &s.position.x,    &s.position.y,   &s.position.z, &s.orientation.w,
          &s.orientation.x, &s.orientation.y, &s.orientation.z};
}

/// Of BodyStates, or of sim::Bodies, whose visible columns have the same names.
template <class States>
ConstColumns columns_of(const States& s) {
  return {&s.velocity.x,    &s.velocity.y,    &s.velocity.z,   &s.spin.x,     &s.spin.y,
          &s.spin.z,        &s.position.x,    &s.position.y,   &s.position.z, &s.orientation.w,
          &s.orientation.x, &s.orientation.y, &s.orientation.z};
}

/// The names of the columns in reports.
inline constexpr std::array<const char*, kColumnCount> kColumnNames = {
    "velocity.x", "velocity.y", "velocity.z",    "spin.x",        "spin.y",        "spin.z",       "position.x",
    "position.y", "position.z", "orientation.w", "orientation.x", "orientation.y", "orientation.z"};

/// The order in which reports look through a body's columns: position, orientation, velocity, spin.
inline constexpr std::array<std::size_t, kColumnCount> kFieldOrder = {
    kPosition, kPosition + 1, kPosition + 2, kOrientation, kOrientation + 1, kOrientation + 2, kOrientation + 3,
    kVelocity, kVelocity + 1, kVelocity + 2, kSpin,        kSpin + 1,        kSpin + 2};

}  // namespace tumble::replay
