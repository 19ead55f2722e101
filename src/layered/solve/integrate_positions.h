#pragma once

#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/world/world.h"

namespace tumble::sim {

/// Moves every body that is in contact by one sub-step, and the separations of its points with it.
/// Reads:  solver_bodies' velocity and spin; contact_batches
/// Writes: position, orientation; points' separation; of uneven bodies the solver's spin and, where they have
///         turned noticeably, inverse inertia
Status integrate_positions(World& world, double substep_s);
void hash_integrate_positions(const World& world, Hasher& hasher);

}  // namespace tumble::sim
