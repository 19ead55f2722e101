#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Lists the bodies of fast pairs with their state, and gives those that move to the solver (in_contact). Takes the
/// contact memory of the last step for that of the substep before.
void list_fast_bodies(const WorldState& state, Scratch& scratch);

/// Marks the bodies that a contact of a fast pair has pressed in this substep.
void mark_pressed(Scratch& scratch);

/// Tells which bodies fly for the rest of this substep: those that no contact presses, or that bounce.
void find_flying(Scratch& scratch);

/// Whether body i flies in this substep, though the solver moves it.
inline bool is_flying(const Scratch& scratch, BodyIndex i) {
  return !scratch.fast.none() && scratch.in_contact[i] == kInFastPair && scratch.fast.bodies[scratch.fast.place[i]].flying;
}

/// The part of this substep that body i has flown before its contacts were solved, s.
inline double flown_s(const Scratch& scratch, std::size_t i) {
  if (scratch.fast.none() || scratch.in_contact[i] != kInFastPair) return 0;
  return scratch.fast.bodies[scratch.fast.place[i]].flown_s;
}

/// Takes the bodies that nothing has pressed out of the solver, with the state that they had at the start of the step:
/// what only passes flies as if alone.
void release_untouched(WorldState& state, Scratch& scratch);

}  // namespace tumble::sim
