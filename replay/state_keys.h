#pragma once

#include <cstdint>

#include "replay/codec1_predictor.h"
#include "replay/columns.h"
#include "replay/little_endian.h"
#include "replay/state_rows.h"

/// How codec 1 turns doubles into the integers whose differences it stores.
namespace tumble::replay::codec1 {

inline constexpr int kVelocityExponent = 38;
inline constexpr int kPositionExponent = 36;
inline constexpr double kKeyMax = 4611686018427387904.0;  // 2⁶²: a prediction beyond says nothing

/// Grid steps per unit of a column; 0 where no grid is tried.
inline constexpr double steps_per_unit(std::size_t column) {
  if (column >= kOrientation) return 0;
  return static_cast<double>(1ULL << (column >= kPosition ? kPositionExponent : kVelocityExponent));
}

/// A whole number of grid steps, small enough to be exact, and not −0.0, which an integer would forget.
inline bool is_on_grid(double value, double steps_per_unit) {
  const double steps = value * steps_per_unit;
  if (!(steps > -4503599627370496.0 && steps < 4503599627370496.0)) return false;  // 2⁵², and NaN
  return static_cast<double>(static_cast<std::int64_t>(steps)) == steps && bits_of(value) != bits_of(-0.0);
}

/// Bit patterns in the order of the values: neighbours in value are neighbours in key, across zero too.
inline std::uint64_t ordered(std::uint64_t bits) { return (bits >> 63) != 0 ? ~bits : bits | 0x8000000000000000; }
inline std::uint64_t unordered(std::uint64_t key) { return (key >> 63) != 0 ? key & 0x7fffffffffffffff : ~key; }

/// The integer of a value: differences of these are stored.
inline std::uint64_t key_of(double value, double steps_per_unit, bool on_grid) {
  if (!on_grid) return ordered(bits_of(value));
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(value * steps_per_unit));
}
inline double value_of(std::uint64_t key, double steps_per_unit, bool on_grid) {
  if (!on_grid) return double_of(unordered(key));
  return static_cast<double>(static_cast<std::int64_t>(key)) / steps_per_unit;
}

/// The integer expected. NaNs differ in their bits from machine to machine, so one is never used.
inline std::uint64_t predicted_key(double predicted, double steps_per_unit, bool on_grid) {
  if (!on_grid) return predicted == predicted ? ordered(bits_of(predicted)) : 0;
  const double steps = predicted * steps_per_unit;
  if (!(steps > -kKeyMax && steps < kKeyMax)) return 0;
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(steps));
}

/// Small differences of either sign become small numbers.
inline std::uint64_t zigzag(std::uint64_t difference) { return (difference << 1) ^ (0 - (difference >> 63)); }
inline std::uint64_t unzigzag(std::uint64_t number) { return (number >> 1) ^ (0 - (number & 1)); }

/// What each column of row i is expected to hold dt after the state stored last.
inline std::array<double, kColumnCount> predict_row(const StateRows& rows, std::size_t i, bool frozen, double dt) {
  const BodyStates& b = rows.before();
  Motion motion = {{b.position.x[i], b.position.y[i], b.position.z[i]},
                   {b.orientation.w[i], b.orientation.x[i], b.orientation.y[i], b.orientation.z[i]},
                   {b.velocity.x[i], b.velocity.y[i], b.velocity.z[i]},
                   {b.spin.x[i], b.spin.y[i], b.spin.z[i]}};
  const sim::Vec3Column& inertia = rows.inertia();
  const sim::Vec3& gravity = rows.gravity();
  motion = predict(motion, {inertia.x[i], inertia.y[i], inertia.z[i]}, {gravity.x(), gravity.y(), gravity.z()},
                   rows.air_drag(), dt);
  if (frozen) motion.velocity = motion.spin = {0, 0, 0};
  return {motion.velocity.x,    motion.velocity.y,    motion.velocity.z,   motion.spin.x,     motion.spin.y,
          motion.spin.z,        motion.position.x,    motion.position.y,   motion.position.z, motion.orientation.w,
          motion.orientation.x, motion.orientation.y, motion.orientation.z};
}

}  // namespace tumble::replay::codec1
