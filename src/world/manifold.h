#pragma once

#include <cstdint>
#include <vector>

#include "src/base/ids.h"
#include "src/math/vec.h"

namespace tumble::sim {

/// What touches what in a contact point, as a physical thing that keeps its name while boxes move: 0–7 a corner of the
/// body with the lower row, 8–15 a corner of the other (bit k set: on the positive side of own axis k), and
/// 16 + 12·e + f an edge e of the lower row crossing an edge f of the other (edge: 4·axis + two side bits, the axes
/// after it in cyclic order). The corners of a body in the ground are 0–7.
using Feature = std::uint32_t;
constexpr Feature corner_feature(bool of_lower_row, unsigned corner) { return (of_lower_row ? 0U : 8U) + corner; }
constexpr Feature crossing_feature(unsigned edge_of_lower, unsigned edge_of_higher) {
  return 16U + 12U * edge_of_lower + edge_of_higher;
}

/// One contact point of a manifold. It lies on the incident body b, at r_b = t1 p + t2 q + n o from b's centre; o is
/// the manifold's. p, q, o in m.
struct ManifoldPoint {
  double p = 0, q = 0;
  double separation = 0;  ///< m along the normal; negative when overlapping
  double impulse = 0;     ///< N·s accumulated along the normal, >= 0
  double load = 0;        ///< N·s a sub-step, what it bears of the weight above when all is at rest
  Feature feature = 0;
  std::uint32_t unused = 0;  ///< rows are hashed as they lie in memory
};

/// All contact points of a pair on one reference face (or of one edge pair), solved together. n points from the
/// reference body a to the incident body b; t1, t2, n are right-handed; d = x_b − x_a (0 for the ground).
struct Manifold {
  BodyIndex a = kGround;  ///< reference body, or kGround
  BodyIndex b = 0;        ///< incident body
  Vec3 n = Vec3::Zero(), t1 = Vec3::Zero(), t2 = Vec3::Zero();
  Vec3 d = Vec3::Zero();               ///< of an asleep manifold: the remembered friction instead
  double offset = 0;                   ///< o: the plane of the points, from b's centre along n
  std::uint32_t first = 0, count = 0;  ///< its points
  std::uint32_t layer = 0;             ///< solved together with all manifolds of the same layer
  bool asleep = false;                 ///< both bodies rest; carried along unsolved
  std::uint8_t unused[3] = {};         ///< rows are hashed as they lie in memory
  double friction = 0, friction_dynamic = 0, restitution = 0;
  double force1 = 0, force2 = 0, twist = 0;  ///< N·s, N·s, N·m·s accumulated by friction
};

/// What the contacts of a step leave for the next: the impulses that warm start it. Part of the state.
/// Ascending by (lower row, higher row, reference first); a = kGround for the ground.
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
