#pragma once

#include "src/layered/find/point_reach.h"
#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Broad phase of method layered: finds the pairs that touch or may touch within the step.
/// Reads:  position, orientation, velocity, spin, half_extent; gravity
/// Writes: frames, aabb_low, aabb_high (swept by the motion of the step), turning; ranges, hit_unevenly
///         (velocity_ranges.h); pairs, ascending by (a, b)
Status find_near_pairs(WorldState& state, Scratch& scratch, double dt_s);
void hash_find_near_pairs(const WorldState& state, const Scratch& scratch, Hasher& hasher);

/// The distance that gravity may add to a body's motion within dt_s, m.
double falling_reach(const WorldDef& def, double dt_s);

}  // namespace tumble::sim
