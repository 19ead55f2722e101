#pragma once

#include "tumble/sim/vec.h"

namespace tumble::sim {

/// The velocity of a body after it has paid, out of its speed along the unit vector `up`, for a lift by `displacement`;
/// and the energy dissipated, J/kg.
/// Source: thesis III.E.
struct LiftCost {
  Vec3 velocity;
  double removed = 0;
  double unpaid = 0;  ///< J/kg of the lift, where that speed was too low
};
LiftCost pay_for_lift(const Vec3& velocity, const Vec3& displacement, const Vec3& gravity, const Vec3& up);

}  // namespace tumble::sim
