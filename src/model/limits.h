#pragma once

#include <cstdint>

namespace tumble::sim {

// Named limits, checked where a value enters. The grids of math/grid.h set those of positions and speeds.
inline constexpr double kPositionMax = 32768;  ///< m, each coordinate
inline constexpr double kSpeedMax = 8192;      ///< m/s and rad/s, each component
/// m/s and rad/s, between substeps. A light body between heavy ones may be faster until the next sweep stops it.
inline constexpr double kSubstepSpeedMax = 16 * kSpeedMax;
/// m/s or rad/s. Sums of gains are exact in any order while the magnitudes of the gains add up to at most this: with a
/// velocity of kSpeedMax that makes 2⁵³ steps of VelocityGrid.
inline constexpr double kGainTotalMax = 3 * kSpeedMax;
inline constexpr double kNormTolerance = 1e-9;  ///< of an orientation's squared length from 1
inline constexpr double kSizeMin = 1e-4;        ///< m, an edge
inline constexpr double kSizeMax = 4096;        ///< m, an edge
inline constexpr double kMassMin = 1e-9;        ///< kg
inline constexpr double kMassMax = 1e12;        ///< kg
inline constexpr double kDtMin = 1e-7;          ///< s
inline constexpr double kDtMax = 1;             ///< s
inline constexpr double kFrictionMax = 1000;
inline constexpr double kGravityMax = 1e4;  ///< m/s², each component
inline constexpr std::uint64_t kBodiesMax = 4'000'000;
inline constexpr std::uint64_t kStepsMax = 100'000'000;
inline constexpr std::uint64_t kInputsMax = 1'000'000;
inline constexpr std::uint32_t kSubstepsMax = 1024;

}  // namespace tumble::sim
