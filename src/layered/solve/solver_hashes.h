#pragma once

#include "src/base/hash.h"
#include "src/world/scratch.h"
#include "src/world/world_state.h"

/// What the phases of method layered write to memory of the solver's own, for their hashes. Contacts are taken as they
/// lie in their batches, which are alike for every lane width; only those that are awake.
namespace tumble::sim {

/// All that prepare_manifolds makes of bodies and contacts. Of what it only copies: points, friction and restitution.
void hash_prepared(const Scratch& scratch, Hasher& hasher);

/// The solver's bodies: their velocities, and what these are found with.
void hash_solver_bodies(const Scratch& scratch, Hasher& hasher);

/// Impulses and the velocities that they have led to: what the phases that sweep write.
void hash_solution(const Scratch& scratch, Hasher& hasher);

/// How far points are apart, and the solver's bodies where there are any whose spin changes as they turn.
void hash_moved(const Bodies& bodies, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
