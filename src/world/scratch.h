#pragma once

#include <cstdint>
#include <vector>

#include "src/base/ids.h"
#include "src/math/rotation.h"
#include "src/math/vec.h"

namespace tumble::sim {

/// A body's box where it stands: derived from the state at the start of each sub-step's pair search.
struct BoxFrame {
  Vec3 position;     ///< m, world
  Axes axes;         ///< world directions of the box's own axes
  Vec3 half_extent;  ///< m, along them
};

/// Collisions found and what follows from each: the Real Collision List (thesis III.A.2), structure of arrays. Pairs
/// come first, ascending by (a, b), then bodies in the ground, ascending, with b = kGround. Points are offsets from
/// the centres of mass, on PositionGrid, with r_b = r_a − (x_b − x_a) exactly. normal points from a to b.
struct Contacts {
  std::vector<BodyIndex> a;
  std::vector<BodyIndex> b;
  std::vector<std::uint16_t> planes;  ///< the tied axes of least overlap, as in PairTable; 0 for the ground
  Vec3Column normal;
  std::vector<double> depth;  ///< m, > 0
  Vec3Column r_a;
  Vec3Column r_b;      ///< zero for the ground
  Vec3Column impulse;  ///< N·s, on b; a gets its opposite

  [[nodiscard]] std::size_t size() const { return a.size(); }
};

/// Memory that the phases of one sub-step pass on; nothing in it outlives the step, and the future does not depend on
/// it. Kept between steps only so that a warm step does not allocate.
struct Scratch {
  std::vector<BoxFrame> frames;  ///< written by find_pairs
  Vec3Column aabb_low;           ///< written by find_pairs; on PositionGrid
  Vec3Column aabb_high;
  Contacts contacts;         ///< written by find_planes (a, b, planes), find_contacts, compute_impulses
  Vec3Column velocity_gain;  ///< sum of impulse outcomes of each body, m/s; written by compute_impulses
  Vec3Column spin_gain;      ///< likewise, rad/s
  Vec3Column displacement;   ///< merged separation of each body, m; written by compute_separation
  std::vector<std::uint8_t> touched;  ///< in a real collision in this sub-step; written by compute_impulses
  double removed_energy = 0;          ///< J in this step; written by apply_outcomes
};

}  // namespace tumble::sim
