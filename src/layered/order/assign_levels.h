#pragma once

#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/world/scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// Orders the manifolds: how many contacts each body is away from what does not move, and from that the layers in which
/// manifolds are solved together, outward from the ground, and how often. Islands with a bar come last and are swept
/// more often.
/// Reads:  manifolds, frozen, is_static, inertia
/// Writes: level; manifolds' layer; layer_start, layered, sweep_groups
/// Order:  a breadth-first distance is the same whatever the order of visits, and so is an island
/// Source: thesis VI, "shock propagation", after Guendelman, Bridson and Fedkiw (2003). Differs: no body is pinned
///         while the next layer is solved; sweeps alternate up and down instead.
Status assign_levels(WorldState& state, Scratch& scratch, double dt_s);
void hash_assign_levels(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
