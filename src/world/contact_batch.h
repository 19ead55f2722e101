#pragma once

#include <cstdint>

namespace tumble::sim {

/// Manifolds that are solved side by side. Eight lanes whatever the machine: a narrower one takes them in turn, so that
/// memory looks alike everywhere.
inline constexpr int kLanes = 8;

/// How many lanes an instruction takes. All give the same bits: lanes never mix. kWidest: as many as this machine can.
enum class LaneWidth : std::uint8_t { kWidest, kOne, kTwo, kFour, kEight };

/// One number of each of eight manifolds.
struct alignas(64) Lanes {
  double of[kLanes] = {};
};

/// One contact point of each manifold of a batch; the fields are ManifoldPoint's. A lane without such a point holds
/// zeros, which give no impulse.
struct PointBatch {
  Lanes p, q, separation, impulse, mass, approach, peak;
};

/// Up to eight manifolds of one layer, as the solver sees them: the fields are Manifold's. An unused lane holds zeros
/// and the row after the last body, which does not move.
struct ContactBatch {
  std::uint32_t a[kLanes] = {}, b[kLanes] = {};  ///< rows of solver_bodies; the row after the last body is the ground
  std::uint32_t used = 0;                        ///< lanes from the left
  std::uint32_t first = 0, count = 0;            ///< its points, in Scratch::point_batches
  bool bounces = false;                          ///< a point of it met fast enough to bounce
  Lanes n[3], t1[3], t2[3], d[3], offset;
  Lanes split_a, split_b;
  Lanes friction, friction_dynamic, restitution, acceleration;
  Lanes centre_p, centre_q, radius;
  Lanes friction_inverse[6], response[6];
  Lanes relaxation, impulse_magic;
  Lanes force1, force2, twist;
};

}  // namespace tumble::sim
