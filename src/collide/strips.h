#pragma once

#include "src/world/scratch.h"

namespace tumble::sim {

/// Every pair of bodies whose AABBs overlap, ascending by (a, b): as find_overlaps does, but in strips across a second
/// axis, so that the cost does not grow with how many boxes line up along the first; where they crowd, strips across
/// the third axis make cells of them. A box lies in each cell that it reaches; a pair counts in the first that has
/// both. Remembers no planes: method layered has none.
void find_overlaps_in_strips(Scratch& scratch, PairTable& pairs);

}  // namespace tumble::sim
