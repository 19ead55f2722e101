#pragma once

#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/world/scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// Narrow phase of method layered: contact points for every pair that touches or may touch within the step, and the
/// impulses that the same points had in the last step.
/// Reads:  frames, pairs; velocity, spin, frozen; contact memory
/// Writes: manifolds, manifold_points
/// Source: separating axes by Gottschalk (1996). An edge pair must beat the best face by 1 % of the smallest half
///         extent; the reference is the larger box, then the lower one, and both on an exact tie.
Status find_manifolds(WorldState& state, Scratch& scratch, double dt_s);
void hash_find_manifolds(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
