#pragma once

#include <span>

#include "src/world/phase_scratch.h"
#include "tumble/sim/vec.h"

namespace tumble::sim {

/// A body's displacement, and how often what the contacts ask for was read to find it.
struct MergedDisplacement {
  Vec3 displacement;  ///< m, not rounded to a grid
  int sweeps = 0;
};

/// Merges what the contacts of one body ask for: distances pᵢ along directions nᵢ.
///
/// Among things that do not give way, the result d is the shortest of those that minimise Σ max(0, pᵢ − d·nᵢ)². Where
/// one displacement ends every overlap, d is the shortest that does; where contacts oppose one another, they share what
/// is left. A body between two nearly parallel walls could leave only through their far end: where d would be longer
/// than four times the longest pᵢ, Σ max(0, pᵢ − d·nᵢ)² + |d|²·count/16 is minimised instead. Directions that all lie
/// within 75° of one direction never come to this.
///
/// If any of the other bodies gives way too, the sum of all displacements is the reference: those in its direction are
/// merged as above, those in the opposite direction likewise, and the two results are added. The bodies pushed into
/// move on in turn. Sharing would halve the pace at which a stack of moving bodies comes apart.
///
/// Neither the order of `wanted`, nor mirrors in x and y, nor exchanging x and y change a bit. `wanted` is reordered.
/// Source: thesis III.C.1, Figs. 8 and 9, where the first displacement is the reference. Newton's method on a convex,
///         piecewise quadratic function: Mangasarian (2002), A finite Newton method for classification.
/// Precondition: `wanted` is not empty.
MergedDisplacement merge_displacements(std::span<Displacement> wanted);

}  // namespace tumble::sim
