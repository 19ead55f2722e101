#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "src/base/rng.h"
#include "tumble/sim/rotation.h"
#include "tumble/sim/vec.h"

namespace tumble::hunt {

/// The random numbers of one scene: draw k of scene `number` is random_bits(seed, number, k) of src/base/rng.h. Uses
/// no function of the C library that rounds differently on another machine, so that seed and number are one scene on
/// all of them.
class Draws {
 public:
  /// first: the draw to begin with; far from 0 for numbers that shall move none of the others.
  Draws(std::uint64_t seed, std::uint64_t number, std::uint64_t first = 0)
      : seed_(seed), number_(number), draw_(first) {}

  std::uint64_t bits() { return random_bits(seed_, number_, draw_++); }

  /// In [low, high), a multiple of 2⁻⁵³ of the width.
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits() >> 11U) * 0x1p-53);
  }

  /// In [2^low, 2^high), every power of two equally often.
  double magnitude(int low, int high) {
    return std::ldexp(uniform(1, 2), low + static_cast<int>(below(static_cast<std::uint64_t>(high - low))));
  }

  /// In [0, count).
  std::uint64_t below(std::uint64_t count) { return bits() % count; }

  bool chance(double probability) { return uniform(0, 1) < probability; }

  double one_of(std::span<const double> values) { return values[below(values.size())]; }

  /// Each coordinate in [−limit, limit).
  sim::Vec3 vector(double limit) {
    const double x = uniform(-limit, limit), y = uniform(-limit, limit), z = uniform(-limit, limit);
    return {x, y, z};
  }

  /// A direction, not of unit length, never zero.
  sim::Vec3 direction() {
    sim::Vec3 v = vector(1);
    v.x() += v.x() < 0 ? -0.125 : 0.125;
    return v;
  }

  /// Any rotation, of a length that normalising keeps to the last bit, so that a scene's text reads back as it is.
  sim::Quat rotation() {
    for (;;) {
      const double w = uniform(0.125, 1);
      const sim::Vec3 v = vector(1);
      const sim::Quat q = sim::normalised({w, v.x(), v.y(), v.z()});
      if (sim::normalised(q) == q) return q;
    }
  }

 private:
  std::uint64_t seed_, number_, draw_;
};

}  // namespace tumble::hunt
