#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/world_state.h"

/// Hashes of the solver's memory, for the phases of method layered. Contacts are hashed as they lie in the batches,
/// which are alike for every lane width; sleeping contacts are in no batch.
namespace tumble::sim {

/// Adds every field that prepare_manifolds computes, and three that it copies: points, friction and restitution.
void hash_prepared(const Scratch& scratch, Hasher& hasher);

/// Adds the solver's bodies: velocities, masses and inertias.
void hash_solver_bodies(const Scratch& scratch, Hasher& hasher);

/// Adds them with the motion of parting (OverlapScratch) instead of theirs.
void hash_parting_bodies(const Scratch& scratch, Hasher& hasher);

/// Adds the results of a sweep: impulses and the velocities of the solver's bodies.
void hash_solution(const Scratch& scratch, Hasher& hasher);

/// Adds the separations of points, and the solver's bodies if any of them has different moments of inertia: the spin of
/// such a body changes while the body turns.
/// The batches of a step or substep.
void hash_batches(const ContactBatches& all, Hasher& hasher);
void hash_moved(const Bodies& bodies, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
