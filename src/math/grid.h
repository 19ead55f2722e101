#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "src/math/grid_magic.h"
#include "tumble/sim/vec.h"

namespace tumble::sim {

/// Grid doubles: whole multiples of one power of two (the step), small enough that sums of them are exact. Exact sums
/// are associative and commutative, so no result depends on the order of bodies, pairs or threads.
///
/// round(x) adds the magic number 1.5·2⁵²·step and subtracts it again. Doubles near the magic number lie exactly one
/// step apart, so the addition itself rounds x to a multiple of the step, to nearest even, and the subtraction is
/// exact. The factor 1.5 keeps x + magic between 2⁵² and 2⁵³ steps for either sign of x, which makes round(−x) =
/// −round(x); mirror symmetry needs that. Precondition: |x| < 2⁵¹ steps.
/// Source: ExtractScalar of Rump, Ogita and Oishi (2008), Accurate floating-point summation; sums that no order changes
///         as in Demmel and Nguyen (2013), Fast reproducible floating-point summation.
template <int kExponent>
struct Grid {
  static constexpr double kStep = 1.0 / static_cast<double>(1ULL << kExponent);
  static constexpr double kMagic = 6755399441055744.0 * kStep;  // 1.5·2⁵² grid steps
  static constexpr double kLimit = 2251799813685248.0 * kStep;  // 2⁵¹ grid steps

  static double round(double x) { return plus_zero((x + kMagic) - kMagic); }
  static Vec3 round(const Vec3& v) { return {round(v.x()), round(v.y()), round(v.z())}; }

  /// For |x| of any size; what is beyond the range lies on a grid with wider steps.
  static double round_any(double x);
  static Vec3 round_any(const Vec3& v) { return {round_any(v.x()), round_any(v.y()), round_any(v.z())}; }
};

using PositionGrid = Grid<36>;  ///< 1.5e-11 m, within ±32,768 m
using VelocityGrid = Grid<38>;  ///< 3.6e-12 m/s or rad/s, within ±8,192
using UnitGrid = Grid<48>;      ///< parts of unit vectors and weights, within ±8
static_assert(PositionGrid::kMagic == kPlaceMagic && PositionGrid::kStep == kPlaceStep);
static_assert(VelocityGrid::kMagic == kMotionMagic && UnitGrid::kMagic == kUnitMagic);

/// The largest power of two not above x, read from the exponent bits. Scales a grid to a range.
/// 0 for 0. Precondition: x >= 0, not subnormal.
inline double power_of_two(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0x7ff0000000000000ULL);
}

/// x rounded to the grid of a magic number.
inline double to_grid(double magic, double x) { return (x + magic) - magic; }

/// The magic number of a grid for a sum whose terms have magnitudes of at most a third of `magnitudes`, and all
/// together of at most `magnitudes`: `usual` wherever that grid holds such a sum, else the next that does. A sum with
/// terms of any size is exact, and the same in any order, if its largest term chooses the grid.
inline double fitting_magic(double usual, double magnitudes) {
  return magnitudes <= usual ? usual : 3 * power_of_two(magnitudes);
}

template <int kExponent>
double Grid<kExponent>::round_any(double x) {
  const double magic = fitting_magic(kMagic, 3 * std::fabs(x));
  return plus_zero(to_grid(magic, x));
}

}  // namespace tumble::sim
