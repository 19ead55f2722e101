#pragma once

#include <span>

#include "src/world/scratch.h"

namespace tumble::sim {

/// Appends the manifolds and points that workers have found to those of the first worker, in the order of workers.
/// found: of all other workers; their points count from 0.
void join_lists(std::span<ManifoldList> found, Workers* workers, LargeVector<Manifold>& manifolds,
                LargeVector<ManifoldPoint>& points);

}  // namespace tumble::sim
