#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/manifold.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// The velocities that bodies may get within a step. A body that a third one stops or hits leaves its path, and meets
/// what that path does not: the next of a falling column, or the ground. That matters where a way is longer than half
/// the thickness of the thinner of two bodies; boxes that overlap by less can still be told apart and parted.

/// Times as heavy, from which a pair is uneven: few sweeps leave over of the heavy one's impulse what throws the light
/// one aside.
inline constexpr double kMuchHeavier = 16;

/// Finds scratch.ranges: of each body that a fast one may hit, the range from its own velocity and none to those of
/// all that may hit it; and scratch.hit_unevenly, where one of the two is much heavier. Needs the pairs of the step.
/// Returns whether a body may be hit so.
bool find_velocity_ranges(const WorldState& state, Scratch& scratch, double dt_s);

/// Feeds both; nothing in a step that has none.
void hash_velocity_ranges(const Scratch& scratch, Hasher& hasher);

/// Widens the AABBs of the step by the ways at these velocities.
void widen_aabbs(const WorldState& state, Scratch& scratch, double dt_s);

/// How far a body may come down within time_s, m, if others hit it; 0 where it is too slow for that to matter.
double fall_if_hit(const Scratch& scratch, BodyIndex i, double time_s);

/// How much nearer two bodies, neither of them the ground, may come within time_s, m, at most, if others stop or hit
/// them; 0 where they are too slow for that to matter.
double way_most_if_hit(const Scratch& scratch, BodyIndex a, BodyIndex b, double time_s);

/// The same along n, a unit vector from a to b.
double way_if_hit(const Scratch& scratch, BodyIndex a, BodyIndex b, const Vec3& n, double time_s);

/// The same for the two of a manifold, of which one may be the ground.
double way_if_hit(const Scratch& scratch, const Manifold& m, double time_s);

/// How far above the ground corners of a body may be that reach it within time_s, m. fall: m, the way by gravity.
double ground_reach(const Bodies& bodies, const Scratch& scratch, BodyIndex i, double fall, double time_s);

}  // namespace tumble::sim
