#pragma once

#include "src/world/world.h"

namespace tumble::sim {

/// Copies the awake manifolds into batches, layer by layer, and lists for each layer which outcomes are which body's.
/// Which manifolds share a batch shows in nothing but time.
void batch_contacts(World& world);

}  // namespace tumble::sim
