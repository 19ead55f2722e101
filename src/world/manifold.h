#pragma once

#include <cstdint>
#include <vector>

#include "tumble/sim/ids.h"
#include "tumble/sim/vec.h"

namespace tumble::sim {

/// The name of a contact point by the corner or the edges that touch; the name stays while boxes move. 0–7: a corner of
/// the body with the lower row. 8–15: a corner of the other body (bit k set: on the positive side of own axis k).
/// 16 + 12·e + f: edge e of the lower row crosses edge f of the other body (an edge is 4·axis + two side bits, for the
/// two axes after it in cyclic order). Corners of a body in the ground are 0–7.
using Feature = std::uint32_t;
constexpr Feature corner_feature(bool of_lower_row, unsigned corner) { return (of_lower_row ? 0U : 8U) + corner; }
constexpr Feature crossing_feature(unsigned edge_of_lower, unsigned edge_of_higher) {
  return 16U + 12U * edge_of_lower + edge_of_higher;
}

/// One contact point of a manifold, on the incident body b at r_b = t1 p + t2 q + n o from b's centre; o is the
/// manifold's `offset`. p, q and o are in m.
struct ManifoldPoint {
  double p = 0, q = 0;
  double separation = 0;  ///< m along the normal; negative when overlapping
  double impulse = 0;     ///< N·s accumulated along the normal, >= 0
  double load = 0;        ///< N·s a substep, share of the weight above that the point bears at rest
  Feature feature = 0;
  std::uint32_t unused = 0;  ///< rows are hashed as they lie in memory: no padding
};

/// The contact points of a pair on one reference face (or the point of one edge pair), solved together. n points from
/// the reference body a to the incident body b; t1, t2, n are right-handed; d = x_b − x_a (0 for the ground).
struct Manifold {
  BodyIndex a = kGround;  ///< reference body, or kGround
  BodyIndex b = 0;        ///< incident body
  Vec3 n = Vec3::Zero(), t1 = Vec3::Zero(), t2 = Vec3::Zero();
  Vec3 d = Vec3::Zero();               ///< in a manifold that is asleep: the remembered friction, N·s
  double offset = 0;                   ///< o: the plane of the points, from b's centre along n
  std::uint32_t first = 0, count = 0;  ///< its points
  std::uint32_t layer = 0;             ///< manifolds of one layer are solved together
  bool asleep = false;                 ///< both bodies rest; kept, but not solved
  std::uint8_t unused[3] = {};         ///< rows are hashed as they lie in memory: no padding
  double friction = 0, friction_dynamic = 0, restitution = 0;
  double force1 = 0, force2 = 0, twist = 0;  ///< N·s, N·s, N·m·s accumulated by friction
};

/// The impulses of a step's contacts, from which the next step starts (warm start). Part of the state. Ascending by
/// (lower row, higher row, reference first); a = kGround for the ground.
struct ContactMemory {
  std::vector<BodyIndex> a, b;       ///< reference, incident
  std::vector<std::uint32_t> count;  ///< points
  Vec3Column friction;               ///< N·s on b, world axes
  std::vector<double> twist;         ///< N·m·s on b about the normal
  std::vector<Feature> feature;      ///< of the points, manifold by manifold
  std::vector<double> impulse;       ///< N·s

  [[nodiscard]] std::size_t size() const { return a.size(); }
  void clear() { *this = {}; }
  friend bool operator==(const ContactMemory&, const ContactMemory&) = default;
};

}  // namespace tumble::sim
