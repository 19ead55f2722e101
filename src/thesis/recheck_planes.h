#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Forgets planes that no longer separate their pairs after displacements, so that the next step does not take one for
/// the plane of a collision.
/// Reads:  position, touched; pairs
/// Writes: frames' positions; pairs.planes
/// Source: thesis III.A.2 and III.C.1: "the existing SP is re-checked to be sure that it is still separating"
Status recheck_planes(WorldState& state, Scratch& scratch, double dt_s);
void hash_recheck_planes(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
