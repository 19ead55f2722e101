#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Computes the impulse of every collision from the velocities before all collisions; applies none (thesis III.C).
/// Reads:  contacts; velocity, spin, orientation (through frames), masses, material
/// Writes: contacts.impulse; gains, hit, touched
/// Errors: a gain that is not finite or beyond limits.h; gains of a body that together are beyond kGainTotalMax
/// Order:  each gain is rounded to the velocity grid, so their sums are exact in any order
/// Source: thesis III.B, eq. 3.1 and Coulomb friction (collision_impulse.h). Differs: where several collisions of a
/// body
///         would push too far together, each meets a part of its mass (split_mass.h).
Status compute_impulses(WorldState& state, Scratch& scratch, double dt_s);
void hash_compute_impulses(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
