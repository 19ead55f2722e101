#pragma once

#include "src/world/scratch.h"

namespace tumble::sim {

/// The row of a body of the solver; the ground has the last one.
inline BodyIndex solver_row(const Scratch& scratch, BodyIndex i) {
  return i == kGround ? static_cast<BodyIndex>(scratch.solver_bodies.size() - 1) : i;
}
inline const SolverBody& solver_body(const Scratch& scratch, BodyIndex i) {
  return scratch.solver_bodies[solver_row(scratch, i)];
}

/// I⁻¹ torque in world axes: the change of spin that an angular impulse makes.
inline Vec3 spin_of(const SolverBody& body, const Vec3& t) {
  const double* i = body.inverse_inertia;
  return {(i[0] * t.x() + i[1] * t.y()) + i[2] * t.z(), (i[1] * t.x() + i[3] * t.y()) + i[4] * t.z(),
          (i[2] * t.x() + i[4] * t.y()) + i[5] * t.z()};
}

/// Fills the world inverse inertia of a body from its principal one, each sum in the order x, y, z.
inline void set_inverse_inertia(SolverBody& body, const Axes& axes, const Vec3& principal) {
  const auto entry = [&](int row, int column) {
    const auto part = [&](int k) { return axes[k][row] * axes[k][column] * principal[k]; };
    return (part(0) + part(1)) + part(2);
  };
  if (principal.x() == principal.y() && principal.y() == principal.z()) {
    for (double& value : body.inverse_inertia) value = 0;
    body.inverse_inertia[0] = body.inverse_inertia[3] = body.inverse_inertia[5] = principal.x();
    return;
  }
  int at = 0;
  for (int row = 0; row < 3; ++row) {
    for (int column = row; column < 3; ++column) body.inverse_inertia[at++] = entry(row, column);
  }
}

}  // namespace tumble::sim
