#pragma once

#include <limits>

#include "tumble/sim/scene.h"

namespace tumble::replay {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The space in which the bodies of a session belong; a body outside is lost. The space is the block that the start and
/// the boxes thrown in fill, with the ground below them, widened by a reach, and cut off at the floor. The reach is
/// kReasonableDistance or, where that is longer, the longest edge of the block, the way that the body can have gone by
/// the speeds that it can have got, and the way that gravity can have taken it: along its own direction ½ g t², and to
/// any side at the speed of a fall from the top of the block to the floor. The floor is the ground or, without ground,
/// the lowest corner of any static box; without both there is no floor.
class ReasonableSpace {
 public:
  static constexpr double kReasonableDistance = 1000;  ///< m

  explicit ReasonableSpace(bool ground);

  /// Takes a box of the start or one thrown in, with its position and orientation then.
  void add(const sim::BoxDef& box);

  /// A step of dt, s, is taken under this gravity, m/s².
  void pass(double dt, const sim::Vec3& gravity);

  /// way: m, that the body can have gone by the speeds that it was given.
  [[nodiscard]] bool holds(const sim::Vec3& centre, double way) const;

 private:
  bool ground_;
  double floor_;
  sim::Vec3 low_, high_;
  sim::Vec3 down_speed_ = sim::Vec3::Zero(), up_speed_ = sim::Vec3::Zero();  // m/s, of gravity, along −axis and +axis
  sim::Vec3 down_way_ = sim::Vec3::Zero(), up_way_ = sim::Vec3::Zero();      // m
  double fall_way_ = 0;                                                      // m, to any side after a fall
};

}  // namespace tumble::replay
