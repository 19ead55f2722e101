#pragma once

#include <cmath>

#include "src/math/grid.h"
#include "src/world/scratch.h"

namespace tumble::sim {

/// Sets the world inverse inertia from the principal one: R diag(principal) Rᵀ, each sum in the order x, y, z.
inline void set_inverse_inertia(SolverBody& body, const Axes& axes, const Vec3& principal) {
  const auto entry = [&](int row, int column) {
    const auto part = [&](int k) { return axes[k][row] * axes[k][column] * principal[k]; };
    return (part(0) + part(1)) + part(2);
  };
  if (turns_evenly(principal)) {
    for (double& value : body.inverse_inertia) value = 0;
    body.inverse_inertia[0] = body.inverse_inertia[3] = body.inverse_inertia[5] = principal.x();
    return;
  }
  int at = 0;
  for (int row = 0; row < 3; ++row) {
    for (int column = row; column < 3; ++column) body.inverse_inertia[at++] = entry(row, column);
  }
}

/// Makes the body act along the unit vector `along` as if it had 1 / part of its mass, and as much of its moments of
/// inertia about axes across; part: 0 … 1. Motion across `along`, and turning about it, stay as they are. Sets `lent`
/// and changes the inverse inertia A to S A S, S = √part (1 − along alongᵀ) + along alongᵀ.
inline void lend(SolverBody& body, double part, const Vec3& along) {
  body.lent = along * std::sqrt((1 - part) * body.inverse_mass);
  const double root = std::sqrt(part);
  double* const inverse = body.inverse_inertia;
  const double a[3][3] = {
      {inverse[0], inverse[1], inverse[2]}, {inverse[1], inverse[3], inverse[4]}, {inverse[2], inverse[4], inverse[5]}};
  double s[3][3], sa[3][3], sas[3][3];
  const auto multiply = [](const double(&x)[3][3], const double(&y)[3][3], double(&product)[3][3]) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) product[i][j] = (x[i][0] * y[0][j] + x[i][1] * y[1][j]) + x[i][2] * y[2][j];
    }
  };
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) s[i][j] = (i == j ? root : 0.0) + (1 - root) * (along[i] * along[j]);
  }
  multiply(s, a, sa);
  multiply(sa, s, sas);
  int at = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) inverse[at++] = 0.5 * (sas[i][j] + sas[j][i]);
  }
}

/// Keeps the momentum that body i had before inertia was lent: what remains of its motion along `along`, and of turns
/// about axes across, is `part` of it. Without this a push on the body would press with the inertia that it was lent.
inline void keep_momentum(SolverBody& body, double part, const Vec3& along) {
  const double along_v = dot(along, body.velocity), along_w = dot(along, body.spin);
  body.velocity = VelocityGrid::round(Vec3(body.velocity - along * ((1 - part) * along_v)));
  body.spin = VelocityGrid::round(Vec3(body.spin * part + along * ((1 - part) * along_w)));
}

/// Sets the inverse inertia of body i, and what it has been lent.
inline void set_inertia(SolverBody& body, const Bodies& bodies, const Scratch& scratch, BodyIndex i, const Axes& axes) {
  set_inverse_inertia(body, axes, bodies.inverse_inertia[i]);
  const double mass = scratch.solver_mass[i];
  if (mass != bodies.mass[i]) lend(body, bodies.mass[i] / mass, scratch.lent_along[i]);
}

}  // namespace tumble::sim
