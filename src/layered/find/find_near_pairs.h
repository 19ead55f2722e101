#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Broad phase of method layered: finds the pairs that touch or may touch within the step.
/// Reads:  position, orientation, velocity, spin, half_extent; gravity
/// Writes: frames, aabb_low, aabb_high (swept by the motion of the step), turning; pairs, ascending by (a, b)
Status find_near_pairs(WorldState& state, Scratch& scratch, double dt_s);
void hash_find_near_pairs(const WorldState& state, const Scratch& scratch, Hasher& hasher);

/// The slack: points that may come this close within a step become contact points. The slack is kContactSlack (m), or
/// kContactSlackPart of the smallest half extent of the two boxes where that is less.
inline constexpr double kContactSlack = 0.01;
inline constexpr double kContactSlackPart = 0.05;

/// The distance that gravity may add to a body's motion within dt_s, m.
double falling_reach(const WorldDef& def, double dt_s);

}  // namespace tumble::sim
