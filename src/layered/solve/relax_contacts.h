#pragma once

#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/world/scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// Sweeps without the push, after the positions have moved: removes the velocity that the push has added.
/// Reads and writes: impulses in contact_batches; solver_bodies' velocity and spin
/// Order:  sweeps go down and up the levels in turn
Status relax_contacts(WorldState& state, Scratch& scratch, double substep_s);
void hash_relax_contacts(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
