#pragma once

#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/world/scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// The instantaneous displacement that takes each body out of what it overlaps; applied by apply_outcomes.
/// Reads:  contacts; inverse_mass, frozen
/// Writes: displacement
/// Source: thesis III.C.1, Figs. 8 and 9: along the plane's normal, shared by inverse mass, several displacements of a
///         body merged. Differs: the thesis measures the others against "the first"; per world axis,
///         max(0, largest) + min(0, smallest) means the same (same way: the larger one; opposite ways: added) and has
///         no first. Frozen and static bodies do not give way.
/// Order:  largest and smallest of grid doubles; any order
Status compute_separation(WorldState& state, Scratch& scratch, double dt_s);
void hash_compute_separation(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
