#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Applies restitution, once a step: points that were hit leave with e times the speed of the impact.
/// Reads and writes: impulses in contact_batches; solver_bodies' velocity and spin; fast.found and fast.memory
Status bounce_contacts(WorldState& state, Scratch& scratch, double dt_s);
void hash_bounce_contacts(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
