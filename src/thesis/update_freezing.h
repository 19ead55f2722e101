#pragma once

#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/world/scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// Freezes what has come to rest, and wakes what was hit hard enough or has lost its support.
/// Reads:  velocity, spin, position; contacts, touched; the frozen flags as they were before this phase
/// Writes: frozen, low_energy_time, velocity and spin of frozen bodies (0); contact_objects
/// Source: thesis III.D. A body freezes when its kinetic energy per mass is below freeze_energy, has been for
///         freeze_time, and it is in a real collision in this sub-step with something to rest upon: the set of lowest
///         things touched, its contact objects, all of which must be frozen, static or the ground themselves. A frozen
///         body escapes when an impulse would give it more than twice that energy (then it has it), and wakes, at rest,
///         when one of its contact objects moves. Both read the old flags, so waking and freezing climb one level a
///         sub-step whatever the order of bodies. "Low" is along gravity; without gravity nothing freezes.
Status update_freezing(WorldState& state, Scratch& scratch, double dt_s);
void hash_update_freezing(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
