#pragma once

#include "src/world/scratch.h"

namespace tumble::sim {

/// Finds for each layer the layers that share moving bodies with it, from the layers of each body's contacts: a sweep
/// passes a layer by while none of them moves a body. Layers in between may come along; that changes nothing but time.
void find_layer_reach(Scratch& scratch);

}  // namespace tumble::sim
