#pragma once

#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/world/scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// Walks down the levels with the weight that each body carries, for two ends. A contact without a past starts from the
/// impulse that its share of that weight needs, so that a stack stands from the first step on instead of sagging until
/// the sweeps have found out. And a light body that carries a heavy one is given inertia (never weight) by the solver:
/// impulses find their way through a contact in about as many sweeps as the heavy body outweighs the light one.
/// Reads:  mass, velocity, spin, position; gravity; layered, manifolds and their points
/// Writes: solver_mass; load of points; impulses of resting manifolds that have none
/// Order:  sums of shares are of grid doubles, the rest are maxima
/// Source: the thesis's "impact passed through the stack" (VI) as a starting point of the sweeps instead of a
///         substitute for them.
/// Loads are shared by lever arms only where gravity points along z, else evenly. Nothing is handed down through bodies
/// that rest on each other in a ring, nor from what lies below them.
Status carry_weights(WorldState& state, Scratch& scratch, double dt_s);
void hash_carry_weights(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
