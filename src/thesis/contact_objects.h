#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Collects the contact objects of all candidates that are ready (thesis III.D): for each candidate the lowest of the
/// objects that it touches in `contacts` and that may carry it, ties included. A body carries if it lies lower; a
/// static body also if it presses from below, since the centre of a ramp may lie high.
/// Reads:  freezing.candidates. Precondition: their `lowest` is +infinity
/// Writes: freezing.found, ascending and unique; candidates' `lowest`
void collect_contact_objects(const WorldState& state, const Contacts& contacts, FreezeScratch& freezing);

}  // namespace tumble::sim
