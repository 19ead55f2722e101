#pragma once

#include "src/base/hash.h"
#include "src/world/world.h"

/// What the phases of method layered write to memory of the solver's own, for their hashes. Contacts are taken in the
/// order of the manifolds, whatever batches they came into; only those that are awake.
namespace tumble::sim {

/// All that prepare_manifolds makes of bodies and contacts.
void hash_prepared(const World& world, Hasher& hasher);

/// Impulses and the velocities that they have led to: what the phases that sweep write.
void hash_solution(const World& world, Hasher& hasher);

/// What moves with the bodies: their velocities and inertia, how far points are apart.
void hash_moved(const World& world, Hasher& hasher);

/// What store_contacts takes back into manifolds and points.
void hash_stored(const World& world, Hasher& hasher);

}  // namespace tumble::sim
