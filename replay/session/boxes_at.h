#pragma once

#include <vector>

#include "tumble/sim/scene.h"
#include "tumble/sim/world_state.h"

namespace tumble::replay {

/// The bodies of a state as definitions for a scene, in the state's order. `known`: the definitions in the scene and
/// in throws. Each has the parts that a world does not keep (look and origin). A body without a known definition
/// gets one from the state's columns alone.
std::vector<sim::BoxDef> boxes_at(const sim::Bodies& bodies, std::vector<sim::BoxDef> known);

}  // namespace tumble::replay
