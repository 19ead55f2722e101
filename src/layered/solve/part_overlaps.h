#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Moves overlapping bodies apart by a part of their overlap, at 1 m/s at most. The move is no velocity: bodies that
/// overlap at rest stay at rest, and no sweep has to take a push out of the velocities again.
/// Reads:  contact_batches, masses and inertias of solver_bodies
/// Writes: position, orientation; separations in contact_batches; overlaps
/// Source: pseudo-velocities as in split impulses (Guendelman, Bridson and Fedkiw 2003 part position from velocity
///         likewise); solved in layers as the contacts are, so the result depends on no order.
Status part_overlaps(WorldState& state, Scratch& scratch, double dt_s);
void hash_part_overlaps(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
