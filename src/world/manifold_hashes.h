#pragma once

#include "src/base/hash.h"
#include "src/world/scratch.h"

namespace tumble::sim {

/// Manifolds and their points.
void hash_manifolds(const Scratch& scratch, Hasher& hasher);

/// The points alone.
void hash_manifold_points(const Scratch& scratch, Hasher& hasher);

/// The fields of a row, as hash_manifolds() has them.
void add_fields(const Manifold& m, Hasher& hasher);
void add_fields(const ManifoldPoint& point, Hasher& hasher);

}  // namespace tumble::sim
