#pragma once

#include "src/world/scratch.h"

namespace tumble::sim {

/// Writes every pair of bodies whose AABBs overlap, ascending by (a, b), like find_overlaps, but sweeps in strips
/// across a second axis: the cost does not grow with the number of boxes that line up along the first axis. Where boxes
/// crowd, strips across the third axis divide the strips into cells. A box lies in each cell that it reaches; a pair
/// counts in the first cell that holds both. Sets all planes to 0: method layered has none.
void find_overlaps_in_strips(Scratch& scratch, PairTable& pairs);

}  // namespace tumble::sim
