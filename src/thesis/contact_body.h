#pragma once

#include "tumble/sim/rotation.h"
#include "tumble/sim/vec.h"

namespace tumble::sim {

/// How a body answers impulses; an immovable body has zeros.
struct Response {
  double inverse_mass = 0;              ///< 1/kg
  Vec3 inverse_inertia = Vec3::Zero();  ///< 1/(kg·m²)
};

/// One body of a contact.
struct ContactBody : Response {
  Vec3 velocity = Vec3::Zero();  ///< m/s
  Vec3 spin = Vec3::Zero();      ///< rad/s
  Axes axes = axes_of(Quat{});
  Vec3 r = Vec3::Zero();       ///< collision point from the centre of mass, m
  Vec3 gained = Vec3::Zero();  ///< m/s, the part of `velocity` that gravity added in this substep
};

}  // namespace tumble::sim
