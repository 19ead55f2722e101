#pragma once

#include <cstddef>

#include "src/world/hash_on_the_way.h"
#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/world_state.h"

/// Hashes of the solver's memory, for the phases of method layered. Bodies without contact are left out: the solver
/// does not move them, and nothing reads their rows. Contacts are hashed as they lie in the batches, which are alike
/// for every lane width; sleeping contacts are in no batch. Ranges are of rows, or of batches; a sequence of ranges
/// adds what the range of all would.
namespace tumble::sim {

/// Adds the solver's bodies that are in contact with all that prepare_manifolds computes: velocities, masses, inertias.
void add_solver_bodies(const Scratch& scratch, std::size_t begin, std::size_t end, GatheredNumbers& numbers);

/// Adds the velocities of the solver's bodies that are in contact.
void add_solver_velocities(const Scratch& scratch, Hasher& hasher);

/// Adds every field of batches that `prepare` computes, and three that were copied: points, friction and restitution.
/// Levers that no body has turned are those of find_manifolds.
void add_batches(const ContactBatches& all, std::size_t begin, std::size_t end, Hasher& hasher);

/// Adds the batches of fast pairs, in their order, with all that find_fast_contacts and its sweeps write.
void add_fast_batches(const Scratch& scratch, Hasher& hasher);

/// Adds the results of a sweep: impulses and the velocities of the solver's bodies.
void hash_solution(const Scratch& scratch, Hasher& hasher);

/// Adds the separations of points.
void add_separations(const ContactBatches& all, std::size_t begin, std::size_t end, GatheredNumbers& numbers);

/// Adds the separations of points, levers that have turned and, of batches that `renew` computes anew, all that
/// add_batches adds.
void add_moved_contacts(const ContactBatches& all, std::size_t begin, std::size_t end, GatheredNumbers& numbers);

}  // namespace tumble::sim
