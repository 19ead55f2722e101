#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Ends the motion of a step: bodies in contact get the solved velocities, all other bodies move in free flight for the
/// whole step, and the contact memory gets the impulses for the next step.
/// Reads:  solver_bodies, manifolds, in_contact
/// Writes: velocity, spin; position and orientation of flying bodies; contact_memory
/// Errors: a body that is not finite or beyond limits.h
Status finish_motion(WorldState& state, Scratch& scratch, double dt_s);
void hash_finish_motion(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
