#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "replay/codec/codec1_predictor.h"
#include "replay/codec/state_rows.h"
#include "replay/format/little_endian.h"
#include "tumble/replay/body_states.h"

/// The integers that codec 1 stores differences of, computed from doubles.
namespace tumble::replay::codec1 {

inline constexpr int kVelocityExponent = 38;
inline constexpr int kPositionExponent = 36;
inline constexpr double kKeyMax = 2251799813685248.0;   // 2⁵¹: a larger prediction is not used
inline constexpr double kRounder = 6755399441055744.0;  // 1.5·2⁵²: adding and subtracting it rounds to integers

/// Grid steps per unit of a column; 0 for a column without a grid.
inline constexpr double steps_per_unit(std::size_t column) {
  if (column >= kOrientation) return 0;
  return static_cast<double>(1ULL << (column >= kPosition ? kPositionExponent : kVelocityExponent));
}

/// Whether a value is a whole number of grid steps, small enough to be exact. −0.0 is not: an integer has no sign of
/// zero.
inline bool is_on_grid(double value, double steps_per_unit) {
  const double steps = value * steps_per_unit;
  if (!(steps > -4503599627370496.0 && steps < 4503599627370496.0)) return false;  // 2⁵², and NaN
  return static_cast<double>(static_cast<std::int64_t>(steps)) == steps && bits_of(value) != bits_of(-0.0);
}

/// Maps the bits of doubles to integers in the order of the values, so that close values have close integers, also
/// across zero.
inline std::uint64_t ordered(std::uint64_t bits) { return (bits >> 63) != 0 ? ~bits : bits | 0x8000000000000000; }
inline std::uint64_t unordered(std::uint64_t key) { return (key >> 63) != 0 ? key & 0x7fffffffffffffff : ~key; }

/// The integer of a value.
inline std::uint64_t key_of(double value, double steps_per_unit, bool on_grid) {
  if (!on_grid) return ordered(bits_of(value));
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(value * steps_per_unit));
}
inline double value_of(std::uint64_t key, double steps_per_unit, bool on_grid) {
  if (!on_grid) return double_of(unordered(key));
  return static_cast<double>(static_cast<std::int64_t>(key)) / steps_per_unit;
}

/// The integer of a predicted value. Returns 0 for NaN, because the bits of a computed NaN differ between machines.
inline std::uint64_t predicted_key(double predicted, double steps_per_unit, bool on_grid) {
  if (!on_grid) return predicted == predicted ? ordered(bits_of(predicted)) : 0;
  const double steps = predicted * steps_per_unit;
  if (!(steps > -kKeyMax && steps < kKeyMax)) return 0;
  return static_cast<std::uint64_t>(static_cast<std::int64_t>((steps + kRounder) - kRounder));
}

/// Maps small differences of either sign to small numbers.
inline std::uint64_t zigzag(std::uint64_t difference) { return (difference << 1) ^ (0 - (difference >> 63)); }
inline std::uint64_t unzigzag(std::uint64_t number) { return (number >> 1) ^ (0 - (number & 1)); }

/// The motion of row i.
inline Motion motion_of(const BodyStates& s, std::size_t i) {
  return {{s.position.x[i], s.position.y[i], s.position.z[i]},
          {s.orientation.w[i], s.orientation.x[i], s.orientation.y[i], s.orientation.z[i]},
          {s.velocity.x[i], s.velocity.y[i], s.velocity.z[i]},
          {s.spin.x[i], s.spin.y[i], s.spin.z[i]}};
}

/// The columns of one row, in the order of ColumnIndex.
using Row = std::array<double, kColumnCount>;

inline Row row_of(const Motion& m) {
  return {m.velocity.x, m.velocity.y, m.velocity.z,    m.spin.x,        m.spin.y,        m.spin.z,       m.position.x,
          m.position.y, m.position.z, m.orientation.w, m.orientation.x, m.orientation.y, m.orientation.z};
}

inline bool same_bits(const Row& a, const Row& b) {
  std::uint64_t difference = 0;
  for (std::size_t c = 0; c < kColumnCount; ++c) difference |= bits_of(a[c]) ^ bits_of(b[c]);
  return difference == 0;
}

/// Free flight of row i for dt.
inline Motion fly(const StateRows& rows, std::size_t i, const Motion& before, double dt) {
  const sim::Vec3Column& inertia = rows.inertia();
  const sim::Vec3& g = rows.gravity();
  return fly(before, {inertia.x[i], inertia.y[i], inertia.z[i]}, {g.x(), g.y(), g.z()}, rows.air_drag(), dt);
}

/// The index of the largest component of a quaternion; the first of equal ones. Stored last, because the other three
/// determine it up to rounding.
inline std::size_t largest(const Q4& q) {
  const std::array<double, 4> size = {std::fabs(q.w), std::fabs(q.x), std::fabs(q.y), std::fabs(q.z)};
  std::size_t at = 0;
  for (std::size_t k = 1; k < 4; ++k) {
    if (size[k] > size[at]) at = k;
  }
  return at;
}

/// Calls code(slot, column, predicted) for the columns of a body that touched something, in the order of storage.
/// `code` returns the value of the column: the encoder looks the value up, the decoder adds the stored difference.
/// Later predictions use values that `code` returned.
template <class Code>
Row code_row(const Motion& before, bool frozen, double dt, Code code) {
  Row row;
  const V3 rest = {0, 0, 0};
  const Motion start = {before.position, before.orientation, frozen ? rest : before.velocity,
                        frozen ? rest : before.spin};
  const Row first = row_of(start);
  for (std::size_t c = kVelocity; c < kPosition; ++c) row[c] = code(c, c, first[c]);
  const V3 v1 = {row[0], row[1], row[2]};
  const V3 w1 = {row[3], row[4], row[5]};
  const V3 x1 = carried(before.position, before.velocity, v1, dt);
  row[kPosition] = code(kPosition, kPosition, x1.x);
  row[kPosition + 1] = code(kPosition + 1, kPosition + 1, x1.y);
  row[kPosition + 2] = code(kPosition + 2, kPosition + 2, x1.z);
  const Q4 q1 = turned(before.orientation, before.spin, w1, dt);
  const std::array<double, 4> guess = {q1.w, q1.x, q1.y, q1.z};
  const std::size_t last = largest(q1);
  std::array<double, 3> others;
  for (std::size_t k = 0, slot = 0; k < 4; ++k) {
    if (k == last) continue;
    others[slot] = row[kOrientation + k] = code(kOrientation + slot, kOrientation + k, guess[k]);
    ++slot;
  }
  const double expected = fourth(others[0], others[1], others[2], guess[last] < 0);
  row[kOrientation + last] = code(kColumnCount - 1, kOrientation + last, expected);
  return row;
}

}  // namespace tumble::replay::codec1
