#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Finds the islands of a step, IslandScratch::of: sets of moving bodies that awake contacts connect; and
/// IslandScratch::hit, those that contacts and fast pairs connect. Bodies at rest connect nothing. What a phase takes
/// from other bodies than a contact's own, it takes from their island: what happens elsewhere changes no bit of it.
/// Needs the graph of contacts.
void find_islands(const WorldState& state, Scratch& scratch);

}  // namespace tumble::sim
