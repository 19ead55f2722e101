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
///         body merged. Differs: the thesis compares each displacement with "the first". Here each world axis takes
///         max(0, largest) + min(0, smallest): the larger of two in one direction, the sum of two in opposite
///         directions, as in the thesis, but without a first. Frozen and static bodies do not give way.
/// Order:  largest and smallest of grid doubles; any order
Status compute_separation(WorldState& state, Scratch& scratch, double dt_s);
void hash_compute_separation(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
