#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Finds the islands in which a contact is hit fast enough to bounce; and those in which others of its layer share the
/// mass of one of its bodies, as where a crate slides into a corner, or into two others at a time. One sweep stops and
/// throws back only a part of such a hit.
/// Reads:  layers, islands, manifolds, velocities
/// Writes: IslandScratch::hits
void find_hits(const WorldState& state, Scratch& scratch);

}  // namespace tumble::sim
