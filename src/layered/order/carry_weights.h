#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Passes the weight of every body down to the bodies that support it. The phases use the result twice:
/// - A new contact starts from the impulse that carries its share of the weight, so that a stack stands from the first
///   step on. Otherwise the stack sags until the sweeps have found that impulse.
/// - A light body that holds up a heavy one gets the heavy one's inertia (never its weight) in the solver, along the
///   normals of its supports alone (lend_inertia.h).
/// Reads:  mass, velocity, spin, position; gravity; layered, manifolds and their points
/// Writes: solver_mass, lent_along, held; load of points; impulses of resting manifolds that have none
/// Order:  sums of shares are of grid doubles, the rest are maxima
/// Source: the thesis's "impact passed through the stack" (VI), as a start for the sweeps instead of a substitute for
///         them.
/// Limits: loads follow lever arms only where gravity points within 60° of z; otherwise they are even. Bodies that rest
///         on each other in a ring pass nothing on, nor do the bodies below it.
Status carry_weights(WorldState& state, Scratch& scratch, double dt_s);
void hash_carry_weights(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
