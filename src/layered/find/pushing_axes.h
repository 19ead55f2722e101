#pragma once

#include "src/collide/box_pair.h"

namespace tumble::sim {

/// |Cosine| below which two axes are two directions.
inline constexpr double kOtherDirection = 0.5;

/// How two boxes move from the places of a BoxPair on.
struct PairMotion {
  Vec3 way;             ///< m, of b against a
  Vec3 turn_a, turn_b;  ///< rad: spin times time
};

/// The axes along which a pair may push within a motion.
struct PushingAxes {
  bool all = true;      ///< the motion decides nothing: the largest separation tells
  bool passing = true;  ///< else: an axis stays open, so nothing pushes that does not touch now
  AxisSet axes = 0;     ///< else: these push alone
};

/// How far boxes may overlap along an axis that counts as open, m.
struct OpenOverlap {
  double resting;  ///< of boxes that come together in the motion
  double most;     ///< of boxes that overlap before it; no less
};
/// The overlap of a body that slides over tiles, m: it sinks by a slop, and its front deeper the faster it comes, by up
/// to 2 % of its way in a substep. slop, way: m.
inline double sliding_overlap(double slop, double way) { return 1.8 * slop + 0.02 * way; }

/// An axis is open while the boxes are apart along it or overlap no more than `overlap` says: boxes with an open axis
/// do not press one another along others. Where only one direction is open, or directions within 60°, the motion
/// decides nothing. Where more are:
///   - of those that stay open during the motion, one alone may push: a box that slides over the seam of two tiles is
///     carried by their tops and not stopped by the side of the second. Two that stay open leave only an edge to touch,
///     and the pair passes, unless it pressed before;
///   - if all close, those that close last are where the boxes meet.
/// Turns are bounded to the second order of their angle.
PushingAxes pushing_axes(const BoxPair& boxes, const PairMotion& motion, const OpenOverlap& overlap);

}  // namespace tumble::sim
