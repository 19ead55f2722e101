#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Copies the awake manifolds into batches, layer by layer, and lists, for each layer and body, the outcomes
/// that the body gets. The choice of manifolds that share a batch changes nothing but time.
void batch_contacts(const WorldState& state, Scratch& scratch);

/// The like for the contacts of fast pairs, in one layer. Those of an island with a slender body in a fast pair
/// are hard.
void batch_fast_contacts(const WorldState& state, Scratch& scratch);

}  // namespace tumble::sim
