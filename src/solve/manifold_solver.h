#pragma once

#include <span>

#include "src/world/scratch.h"

namespace tumble::sim {

// The mathematics of one manifold. A manifold's points lie in a plane, so what the normal impulses λ of its points do
// to the bodies depends only on three sums, S = Σλ, Sq = Σλq, Sp = Σλp, and what the bodies do to the points only on
// three numbers: the normal velocity u at b's centre and the parts W1, W2 of the relative spin, v(p, q) = u + W1 q − W2
// p.

/// Motion of b against a at a manifold. U: of b's centre in a's (moving) frame; W: relative spin.
struct RelativeMotion {
  Vec3 u;
  Vec3 w;
};
RelativeMotion relative_motion(const Manifold& m, const SolverBody& a, const SolverBody& b);

/// A wrench on b: a force through b's centre and a torque, as impulses. a receives the opposite at the same place.
struct Wrench {
  Vec3 force;
  Vec3 torque;
};
/// Torque on a's centre that belongs to the opposite of `wrench`.
Vec3 reaction_torque(const Manifold& m, const Wrench& wrench);

/// Fills everything the solver needs that stays fixed during a step.
void prepare_manifold(Manifold& m, std::span<ManifoldPoint> points, const SolverBody& a, const SolverBody& b,
                      double lighter_mass);

/// Rounds impulses to a power-of-two grid that is fine for the lighter body, so that their sums have no order.
inline double round_impulse(const Manifold& m, double x) { return (x + m.impulse_magic) - m.impulse_magic; }

}  // namespace tumble::sim
