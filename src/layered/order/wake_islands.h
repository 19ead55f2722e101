#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Wakes a whole sleeping island when a body with more than twice freeze_energy per kilogram is about to touch the
/// island. The island wakes before the contact is solved: a sleeping body has no finite mass in the solver and would
/// throw the other body back like a wall.
/// Reads:  manifolds, velocity, spin, frozen
/// Writes: frozen, low_energy_time; manifolds and points anew if a body woke
Status wake_islands(WorldState& state, Scratch& scratch, double dt_s);
void hash_wake_islands(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
