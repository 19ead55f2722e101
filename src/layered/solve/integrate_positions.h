#pragma once

#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/world/scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// Moves every body that is in contact by one sub-step, and the separations of its points with it.
/// Reads:  solver_bodies' velocity and spin; contact_batches
/// Writes: position, orientation; points' separation; of uneven bodies the solver's spin and, where they have
///         turned noticeably, inverse inertia
Status integrate_positions(WorldState& state, Scratch& scratch, double substep_s);
void hash_integrate_positions(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
