#pragma once

#include <algorithm>

#include "src/collide/box_pair.h"

namespace tumble::sim {

/// The slack: points that may come this close within a step become contact points. The slack is kContactSlack (m), or
/// kContactSlackPart of the smallest half extent of the two boxes where that is less.
inline constexpr double kContactSlack = 0.01;
inline constexpr double kContactSlackPart = 0.05;

inline double smallest_half_extent(const BoxFrame& a, const BoxFrame& b) {
  return std::min(a.half_extent.minCoeff(), b.half_extent.minCoeff());
}
/// The slack of boxes with this smallest half extent, m.
inline double slack_of(double smallest) { return std::min(kContactSlack, kContactSlackPart * smallest); }

}  // namespace tumble::sim
