#pragma once

#include <cstdint>

namespace tumble::sim {

/// Manifolds that are solved side by side. Eight lanes whatever the machine: a narrower one takes them in turn, so that
/// memory looks alike everywhere.
inline constexpr int kLanes = 8;

/// Points of a manifold at most: corners of the reference face (4), of the other box (8), and edges of the one that
/// cross edges of the other (4 · 12); two points have different features.
inline constexpr unsigned kPointsMax = 60;

/// Bodies that move no faster than this along a contact's normal, m/s, rest on each other; faster, they meet or part.
inline constexpr double kRestingSpeed = 0.1;

/// One number of each of eight manifolds.
struct alignas(64) Lanes {
  double of[kLanes] = {};
};

/// One contact point of each manifold of a batch; the fields are ManifoldPoint's. A lane without such a point holds
/// zeros, which give no impulse.
struct PointBatch {
  Lanes p, q, load, separation;
  Lanes impulse;
  Lanes peak;      ///< N·s, the largest impulse of this step: whether it was ever hit
  Lanes mass;      ///< kg, what one N·s along the normal moves by 1 m/s, with the split masses
  Lanes approach;  ///< m/s, normal velocity at which it will meet, or has met; negative when closing
};

/// A body of a layer, and which of the layer's outcomes are its own: [begin, end) of the entries.
struct BodyOutcomes {
  std::uint32_t body = 0, begin = 0, end = 0;
};

/// Up to eight manifolds of one layer, as the solver sees them: the fields are Manifold's. An unused lane holds zeros
/// and the row after the last body, which does not move.
struct ContactBatch {
  std::uint32_t a[kLanes] = {}, b[kLanes] = {};  ///< rows of solver_bodies; the row after the last body is the ground
  std::uint32_t used = 0;                        ///< lanes from the left
  std::uint32_t members = 0;                     ///< where its manifolds begin in ContactBatches::order
  std::uint32_t first = 0, count = 0;            ///< its points
  bool bounces = false;                          ///< a point of it met fast enough to bounce
  bool slender = false;                          ///< of an island with a slender body
  Lanes point_count;                             ///< of each manifold
  Lanes n[3], t1[3], t2[3], d[3], offset;
  Lanes friction, friction_dynamic, restitution;
  Lanes force1, force2, twist;
  Lanes split_a, split_b;  ///< in how many parts the bodies' masses are divided in this layer
  Lanes acceleration;      ///< m/s² along n that gravity alone gives b against a
  Lanes impulse_magic;     ///< rounds impulses to a grid that fits the lighter body
  // Prepared once a step.
  Lanes centre_p, centre_q, radius;  ///< friction acts here, m; mean distance of the points from it
  Lanes friction_inverse[6];         ///< of the 3 × 3 matrix of (t1, t2, twist): 11, 12, 13, 22, 23, 33
  Lanes response[6];                 ///< of (u, W1, W2) to the sums (S, Sq, Sp)
  Lanes relaxation;
};

}  // namespace tumble::sim
