#pragma once

#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/world/world.h"

namespace tumble::sim {

/// Moves every body that is in contact by one sub-step, and the separations of its points with it.
/// Reads:  solver_bodies' velocity and spin; manifolds
/// Writes: position, orientation; points' separation
Status integrate_positions(World& world, double substep_s);
void hash_integrate_positions(const World& world, Hasher& hasher);

}  // namespace tumble::sim
