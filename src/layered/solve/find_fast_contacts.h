#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Finds the contacts of fast pairs (FastContacts) anew in each substep, and prepares them for the solver. Bodies that
/// meet within the substep are moved to the meeting first, so that they are hit where they are and as they are turned.
/// A step without fast pairs does nothing here.
/// Reads:  fast.pairs; position, orientation; solver_bodies
/// Writes: position, orientation, velocity, spin and frames of the bodies of fast pairs; solver_bodies; fast.found,
///         fast.batches
Status find_fast_contacts(WorldState& state, Scratch& scratch, double substep_s);
void hash_find_fast_contacts(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
