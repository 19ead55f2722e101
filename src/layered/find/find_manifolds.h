#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Narrow phase of method layered: finds the contact points of every pair that touches or may touch within the step,
/// and recalls the impulses that those points had in the last step.
/// Reads:  frames, pairs; velocity, spin, frozen; contact memory
/// Writes: manifolds, manifold_points
/// Source: separating axes by Gottschalk (1996). An edge pair must be better than the best face by 1 % of the smallest
///         half extent. The reference body is the larger box, then the lower one. On an exact tie each box is the
///         reference of one manifold, so that no choice by index is made.
Status find_manifolds(WorldState& state, Scratch& scratch, double dt_s);
void hash_find_manifolds(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
