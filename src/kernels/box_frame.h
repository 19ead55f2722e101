#pragma once

#include <cmath>

#include "src/math/rotation.h"
#include "src/math/vec.h"

namespace tumble::sim {

/// A body's box where it stands: derived from the state at the start of each sub-step's pair search.
struct BoxFrame {
  Vec3 position;     ///< m, world
  Axes axes;         ///< world directions of the box's own axes
  Vec3 half_extent;  ///< m, along them
};

/// How far a box reaches from its centre along a world axis (0, 1, 2), m.
inline double reach_along(const BoxFrame& frame, int axis) {
  const Vec3& h = frame.half_extent;
  return (h.x() * std::fabs(frame.axes[0][axis]) + h.y() * std::fabs(frame.axes[1][axis])) +
         h.z() * std::fabs(frame.axes[2][axis]);
}

/// Whether its lowest corner is in the ground.
inline bool reaches_ground(const BoxFrame& frame) { return reach_along(frame, 2) > frame.position.z(); }

/// An eighth of the volume, m³: enough to tell which box is larger.
inline double volume_measure(const BoxFrame& frame) {
  return (frame.half_extent.x() * frame.half_extent.y()) * frame.half_extent.z();
}

}  // namespace tumble::sim
