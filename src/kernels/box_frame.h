#pragma once

#include <algorithm>
#include <cmath>

#include "tumble/sim/rotation.h"
#include "tumble/sim/vec.h"

namespace tumble::sim {

/// A body's box at the body's place; the pair search of each substep derives the frames from the state.
struct BoxFrame {
  Vec3 position;     ///< m, world
  Axes axes;         ///< world directions of the box's own axes
  Vec3 half_extent;  ///< m, along them
};

/// The distance that a box reaches from its centre along a world axis (0, 1, 2), m.
inline double reach_along(const BoxFrame& frame, int axis) {
  const Vec3& h = frame.half_extent;
  return (h.x() * std::fabs(frame.axes[0][axis]) + h.y() * std::fabs(frame.axes[1][axis])) +
         h.z() * std::fabs(frame.axes[2][axis]);
}

/// Whether the lowest corner lies in the ground, z < 0.
inline bool reaches_ground(const BoxFrame& frame) { return reach_along(frame, 2) > frame.position.z(); }

/// The smallest half extent of two boxes, m.
inline double smallest_half_extent(const BoxFrame& a, const BoxFrame& b) {
  return std::min(a.half_extent.minCoeff(), b.half_extent.minCoeff());
}

/// An eighth of the volume, m³; tells which of two boxes is larger.
inline double volume_measure(const BoxFrame& frame) {
  return (frame.half_extent.x() * frame.half_extent.y()) * frame.half_extent.z();
}

}  // namespace tumble::sim
