#pragma once

#include <limits>

#include "tumble/sim/scene.h"

namespace tumble::replay {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The space in which the bodies of a session belong; a body outside is lost. The space is the block that the start and
/// the boxes thrown in fill, widened by a reach, and cut off at the floor. The reach is kReasonableDistance or, where
/// that is longer, the longest edge of the block, and the way that a body goes at the fastest speed that it was given:
/// what was sent far is not lost there. The floor is the ground or, without ground, the lowest corner of any static
/// box; without both there is no floor.
class ReasonableSpace {
 public:
  static constexpr double kReasonableDistance = 1000;  ///< m

  explicit ReasonableSpace(bool ground);

  /// Takes a box of the start or one thrown in, with its position, orientation and velocity then.
  void add(const sim::BoxDef& box);

  /// A body was given this speed, m/s, by the start or by an input.
  void add_speed(double speed);

  /// A step of dt, s, is taken.
  void pass(double dt) { way_ += fastest_ * dt; }

  [[nodiscard]] bool holds(const sim::Vec3& centre) const;

 private:
  bool ground_;
  double floor_;
  double fastest_ = 0, way_ = 0;  // m/s of any body so far; m
  sim::Vec3 low_, high_;
};

}  // namespace tumble::replay
