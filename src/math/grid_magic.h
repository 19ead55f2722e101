#pragma once

namespace tumble::sim {

// The constants of grid.h for the files of src/kernels/lanes/lane_vector.h, which may include no header with functions.
inline constexpr double kMotionMagic = 6755399441055744.0 / 274877906944.0;   ///< VelocityGrid::kMagic
inline constexpr double kPlaceMagic = 6755399441055744.0 / 68719476736.0;     ///< PositionGrid::kMagic
inline constexpr double kUnitMagic = 6755399441055744.0 / 281474976710656.0;  ///< UnitGrid::kMagic
inline constexpr double kPlaceStep = 1.0 / 68719476736.0;                     ///< PositionGrid::kStep, m

}  // namespace tumble::sim
