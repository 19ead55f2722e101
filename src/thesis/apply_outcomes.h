#pragma once

#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/world/scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// All stored outcomes, applied at the same time (thesis III.C): impulses to the velocities of all bodies, frozen ones
/// included (update_freezing decides whether they escape), displacements to the positions of those that move. Height
/// that separation gave is taken back out of the vertical speed.
/// Reads:  velocity_gain, spin_gain, displacement, touched; gravity
/// Writes: velocity, spin, position; removed_energy
/// Errors: a body that is not finite or beyond limits.h
/// Source: thesis III.E: the potential energy of the displacement is removed from the vertical part of the kinetic
///         energy, as far as there is any. "Vertical" is along gravity.
Status apply_outcomes(WorldState& state, Scratch& scratch, double dt_s);
void hash_apply_outcomes(const WorldState& state, const Scratch& scratch, Hasher& hasher);

/// The velocity left when a body is lifted by `displacement` at its own expense; and the energy that took, J/kg.
struct LiftCost {
  Vec3 velocity;
  double removed = 0;
};
LiftCost pay_for_lift(const Vec3& velocity, const Vec3& displacement, const Vec3& gravity);

}  // namespace tumble::sim
