#pragma once

#include "src/kernels/ground_contacts.h"
#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Pointers to what the kernel reads of the state and of the contacts, and to where it writes; valid until a column is
/// resized.
GroundCollisions ground_collisions(const WorldState& state, Scratch& scratch, double dt_s);

}  // namespace tumble::sim
