#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Notes the energies of bodies that may fall asleep after this step, before it changes them.
void note_energies(const WorldState& state, Scratch& scratch, double dt_s);

/// Puts an island to sleep when every body in it has stayed below freeze_energy per kilogram for freeze_time while
/// touching something, gravity holds it on something that does not move, and no force speeds it up: its liveliest body
/// gains less than a part of gravity, nor loses more where it is alone. Nor does an island sleep of which a body moves
/// that lies beyond its supports, or is moved out of a deep overlap. A body that does not rest starts the time of rest
/// of those that touch it anew, and theirs of those that touch them, a contact further with each step.
/// Reads:  velocity, spin; manifolds; held of carry_weights; what part_overlaps moved; the energies of note_energies
/// Writes: low_energy_time, frozen; velocity and spin of bodies that fall asleep (0)
/// Source: thesis III.D, applied to islands: a stack falls asleep as a whole, so no awake part can sag under a sleeping
///         one.
Status update_sleeping(WorldState& state, Scratch& scratch, double dt_s);
void hash_update_sleeping(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
