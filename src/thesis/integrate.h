#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Moves every body that is neither frozen nor static in free flight for dt_s.
/// Reads:  position, orientation, velocity, spin, inertia; gravity, air_drag
/// Writes: position, orientation, velocity, spin
/// Errors: a body that is not finite or beyond limits.h
/// Source: src/world/free_flight.h; the thesis says only "basic integration" by Baraff and Witkin.
Status integrate(WorldState& state, Scratch& scratch, double dt_s);
void hash_integrate(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
