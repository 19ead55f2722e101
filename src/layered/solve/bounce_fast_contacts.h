#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Applies restitution to the contacts of fast pairs, in the substep in which they were hit: by the end of the step the
/// bodies have turned, and an impulse there would add energy or take some. Remembers their impulses for the next
/// substep.
/// Reads and writes: impulses in fast.batches; solver_bodies' velocity and spin
/// Writes: fast.found, fast.memory
Status bounce_fast_contacts(WorldState& state, Scratch& scratch, double substep_s);
void hash_bounce_fast_contacts(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
