#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"

namespace tumble::sim {

/// Adds the manifolds and their points to the hash.
void hash_manifolds(const Scratch& scratch, Hasher& hasher);

/// Adds the points alone.
void hash_manifold_points(const Scratch& scratch, Hasher& hasher);

/// Adds the fields of a row in the order in which they lie in memory.
void add_fields(const Manifold& m, Hasher& hasher);
void add_fields(const ManifoldPoint& point, Hasher& hasher);

}  // namespace tumble::sim
