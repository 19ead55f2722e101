#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Begins a substep: adds gravity, and the impulses that the contacts had in the last substep (warm start). Leaves out
/// bodies without a manifold: finish_motion moves those in free flight.
/// Reads:  manifolds, points; gravity
/// Writes: solver_bodies' velocity and spin
Status apply_forces(WorldState& state, Scratch& scratch, double substep_s);
void hash_apply_forces(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
