#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Sorts the manifolds into layers. The level of a body is its distance from bodies at rest, counted in contacts.
/// Manifolds whose two bodies have the same two levels form a layer and are solved together. Layers go outward from the
/// ground. The layers of hard islands (hard_islands.h) form a group of their own, which comes last. The phase also sets
/// how often the contacts of each island are swept.
/// Reads:  manifolds, frozen, is_static, mass, inertia, velocity
/// Writes: level; manifolds' layer; graph, layer_start, layered, sweep_groups; islands' sweeps
/// Order:  a breadth-first distance does not depend on the order of visits, nor does an island
/// Source: thesis VI, "shock propagation", after Guendelman, Bridson and Fedkiw (2003). Differs: no body is held fixed
///         while the next layer is solved; sweeps go up and down in turn instead.
Status assign_levels(WorldState& state, Scratch& scratch, double dt_s);
void hash_assign_levels(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
