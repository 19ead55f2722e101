#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Broad phase: fills the Active Collision List with the pairs whose AABBs overlap on all three axes (touching counts).
/// Reads:  position, orientation, half_extent; velocity, frozen (for time alone)
/// Writes: frames, aabb_low, aabb_high; pairs, ascending by (a, b). A pair that was in the list keeps its planes; a
///         pair that leaves the list loses its planes.
/// Order:  the list is a set; no choice of axis changes it
/// Source: thesis III.A.1, dynamically sized AABBs, sorted along x, y and z independently. Differs: only the axis with
///         the fewest overlaps is kept sorted and swept; the other two are compared directly. While the list of
///         neighbours (src/collide/sweep.h) is valid, only neighbours are compared, which finds the same set. Extents
///         are rounded outwards to the position grid, so that a shifted scene finds the same pairs.
Status find_pairs(WorldState& state, Scratch& scratch, double dt_s);
void hash_find_pairs(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
