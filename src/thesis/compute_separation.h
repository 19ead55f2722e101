#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Computes the instantaneous displacement that moves each body out of the bodies it overlaps; apply_outcomes applies
/// the displacement.
/// Reads:  contacts; inverse_mass, frozen
/// Writes: displacement
/// Source: thesis III.C.1, Figs. 8 and 9: along the plane's normal, shared by inverse mass, several displacements of a
///         body merged (merge_displacements.h). Frozen and static bodies do not give way.
/// Order:  the merge keeps its bits in any order of contacts
Status compute_separation(WorldState& state, Scratch& scratch, double dt_s);
void hash_compute_separation(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
