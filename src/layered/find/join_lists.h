#pragma once

#include <span>

#include "src/world/phase_scratch.h"
#include "tumble/sim/workers.h"

namespace tumble::sim {

/// Copies the manifolds and points of pieces one behind the other, each by the worker who has found it: its processor
/// holds the lines. lists: by worker.
void join_lists(std::span<const ManifoldPiece> pieces, std::span<const ManifoldList> lists, Workers* workers,
                LargeVector<Manifold>& manifolds, LargeVector<ManifoldPoint>& points);

}  // namespace tumble::sim
