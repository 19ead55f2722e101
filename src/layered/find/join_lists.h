#pragma once

#include <cstddef>
#include <span>

#include "src/world/phase_scratch.h"
#include "tumble/sim/workers.h"

namespace tumble::sim {

/// Copies the manifolds and points of pieces one behind the other, each by the worker who has found it: its processor
/// holds the lines. lists: by worker.
void join_lists(std::span<const ManifoldPiece> pieces, std::span<const ManifoldList> lists, Workers* workers,
                LargeVector<Manifold>& manifolds, LargeVector<ManifoldPoint>& points);

/// Gives each list room for all that its likes have found together, and for what a pair adds before points and
/// manifolds are left out: nobody knows which worker finds how much in the next step, and a warm step allocates
/// nothing. The lists are empty then. Memory that is not written takes none of the machine's.
void make_room(std::span<ManifoldList> lists, std::size_t manifolds, std::size_t points);

}  // namespace tumble::sim
