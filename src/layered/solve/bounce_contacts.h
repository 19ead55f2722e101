#pragma once

#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/world/scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// Applies restitution, once a step: points that were hit leave with e times the speed of the impact.
/// Reads and writes: impulses in contact_batches; solver_bodies' velocity and spin
Status bounce_contacts(WorldState& state, Scratch& scratch, double dt_s);
void hash_bounce_contacts(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
