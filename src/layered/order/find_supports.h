#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Lists for each body the contacts through which it rests on others or on ground, and counts those above it. Writes
/// supports, start and waiting_for. Workers meet in it.
void find_supports(const Bodies& bodies, Scratch& scratch, const Worker& worker);

}  // namespace tumble::sim
