#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Finds the contacts of fast pairs (FastContacts) anew, where the bodies are in this substep, and prepares them for
/// the solver. A step without fast pairs does nothing here.
/// Reads:  fast.pairs; position, orientation; solver_bodies
/// Writes: velocity, spin and frames of the bodies of fast pairs; fast.found, fast.batches
/// Source: the free path of the substep is followed where corners leave their tangents by more than the slop
///         (free_path.h).
Status find_fast_contacts(WorldState& state, Scratch& scratch, double substep_s);
void hash_find_fast_contacts(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
