#pragma once

#include "src/world/scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// Copies the awake manifolds into batches, layer by layer, and lists for each layer which outcomes are which body's.
/// Which manifolds share a batch shows in nothing but time.
void batch_contacts(WorldState& state, Scratch& scratch);

}  // namespace tumble::sim
