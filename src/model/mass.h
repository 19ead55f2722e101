#pragma once

#include "tumble/sim/vec.h"

namespace tumble::sim {

/// Principal moments of a solid box, kg·m², about its own axes. size: edge lengths, m.
inline Vec3 box_inertia(double mass_kg, const Vec3& size) {
  const double xx = size.x() * size.x();
  const double yy = size.y() * size.y();
  const double zz = size.z() * size.z();
  return {mass_kg * (yy + zz) / 12, mass_kg * (xx + zz) / 12, mass_kg * (xx + yy) / 12};
}

/// The largest moment of inertia over the smallest, from which a body is slender.
inline constexpr double kSlender = 16;
inline bool is_slender(const Vec3& inertia) { return inertia.maxCoeff() > kSlender * inertia.minCoeff(); }

}  // namespace tumble::sim
