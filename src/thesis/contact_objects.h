#pragma once

#include "src/world/scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// The contact objects of all candidates that are ready (thesis III.D): for each, those among the things it touches in
/// `contacts` that may carry it and lie lowest, ties included. Only lower bodies carry, and static ones that press from
/// below wherever their centre is: a ramp's may be high. Takes freezing.candidates, whose `lowest` must be +infinity
/// on entry, and gives freezing.found, ascending and unique.
void collect_contact_objects(const WorldState& state, const Contacts& contacts, FreezeScratch& freezing);

}  // namespace tumble::sim
