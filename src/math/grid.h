#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "src/math/grid_magic.h"
#include "src/math/vec.h"

namespace tumble::sim {

/// Grid doubles: values that are whole multiples of a power of two, small enough that sums of them are exact. Exact
/// sums are associative and commutative, so no order of bodies, pairs or threads can show in a result.
///
/// Adding and subtracting 1.5·2⁵²·grid rounds to the grid, to nearest even, and is odd-symmetric: −x gives the
/// negated result, which mirror symmetry needs. Valid for |x| < 2⁵¹·grid.
template <int kExponent>
struct Grid {
  static constexpr double kStep = 1.0 / static_cast<double>(1ULL << kExponent);
  static constexpr double kMagic = 6755399441055744.0 * kStep;  // 1.5·2⁵² grid steps
  static constexpr double kLimit = 2251799813685248.0 * kStep;  // 2⁵¹ grid steps

  static double round(double x) { return plus_zero((x + kMagic) - kMagic); }
  static Vec3 round(const Vec3& v) { return {round(v.x()), round(v.y()), round(v.z())}; }
};

using PositionGrid = Grid<36>;  ///< 1.5e-11 m, within ±32,768 m
using VelocityGrid = Grid<38>;  ///< 3.6e-12 m/s or rad/s, within ±8,192
using UnitGrid = Grid<48>;      ///< parts of unit vectors and weights, within ±8
static_assert(PositionGrid::kMagic == kPlaceMagic && PositionGrid::kStep == kPlaceStep);
static_assert(VelocityGrid::kMagic == kMotionMagic);

/// The largest power of two not above x > 0, by its exponent bits: to make a grid that fits a range.
inline double power_of_two(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0x7ff0000000000000ULL);
}

}  // namespace tumble::sim
