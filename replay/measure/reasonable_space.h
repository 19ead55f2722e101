#pragma once

#include <limits>

#include "tumble/sim/scene.h"

namespace tumble::replay {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The space in which the bodies of a session belong; a body outside is lost. The space is the block that the start and
/// the boxes thrown in fill, widened by kReasonableDistance, and cut off at the floor. The floor is the ground or,
/// without ground, the lowest corner of any static box; without both there is no floor.
class ReasonableSpace {
 public:
  static constexpr double kReasonableDistance = 1000;  ///< m

  explicit ReasonableSpace(bool ground);

  /// Takes a box of the start or one thrown in, with its position and orientation then.
  void add(const sim::BoxDef& box);

  [[nodiscard]] bool holds(const sim::Vec3& centre) const;

 private:
  bool ground_;
  double floor_;
  sim::Vec3 low_, high_;
};

}  // namespace tumble::replay
