#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Moves every body in contact by one substep, and the separations of its points with the body.
/// Reads:  solver_bodies' velocity and spin; contact_batches
/// Writes: position, orientation; points' separation; the solver's spin of bodies with
///         different moments of inertia, and their inverse inertia if they have turned noticeably
Status integrate_positions(WorldState& state, Scratch& scratch, double substep_s);
void hash_integrate_positions(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
