#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Sweeps after the positions have moved, without the push of fast pairs: removes the velocity that it has added.
/// Reads and writes: impulses in contact_batches; solver_bodies' velocity and spin
/// Order:  sweeps go down and up the levels in turn
Status relax_contacts(WorldState& state, Scratch& scratch, double substep_s);
void hash_relax_contacts(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
