#pragma once

#include "src/world/scratch.h"

namespace tumble::sim {

/// The largest moment of inertia over the smallest, from which a body is slender.
inline constexpr double kSlender = 16;
inline bool is_slender(const Vec3& inertia) { return inertia.maxCoeff() > kSlender * inertia.minCoeff(); }

/// Sets the world inverse inertia from the principal one: R diag(principal) Rᵀ, each sum in the order x, y, z.
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
