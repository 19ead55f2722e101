#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Freezes bodies that have come to rest, and wakes bodies that were hit hard enough or have lost their support.
/// Reads:  velocity, spin, position; contacts, touched; the frozen flags as they were before this phase
/// Writes: frozen, low_energy_time, velocity and spin of frozen bodies (0); contact_objects
/// Source: thesis III.D. A body freezes under three conditions: its kinetic energy per mass has been below
///         freeze_energy for freeze_time; it is in a real collision in this substep; and all its contact objects (the
///         lowest objects that it touches) are frozen, static or the ground. A frozen body escapes, with the velocity
///         of the impulse, when an impulse would give it more than twice freeze_energy. It wakes, at rest, when one of
///         its contact objects moves. Both rules read the flags from before the phase, so waking and freezing climb one
///         level of a stack a substep in any order of bodies. "Low" is along gravity; without gravity nothing freezes.
Status update_freezing(WorldState& state, Scratch& scratch, double dt_s);
void hash_update_freezing(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
