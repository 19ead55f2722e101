#pragma once

#include "src/model/scene.h"

namespace tumble::replay {

/// Where the bodies of a session may be; one that is elsewhere is lost. The space reaches from the floor, which is the
/// ground or, without one, the lowest corner of any static box, to kReasonableDistance from the block of space that the
/// start and the boxes thrown in fill. Without ground and static boxes there is no floor.
class ReasonableSpace {
 public:
  static constexpr double kReasonableDistance = 1000;  ///< m

  explicit ReasonableSpace(bool ground);

  /// A box of the start, or one thrown in; box.position and box.orientation are where it was then.
  void add(const sim::BoxDef& box);

  [[nodiscard]] bool holds(const sim::Vec3& centre) const;

 private:
  bool ground_;
  double floor_;
  sim::Vec3 low_, high_;
};

}  // namespace tumble::replay
