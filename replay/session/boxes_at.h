#pragma once

#include <vector>

#include "src/model/scene.h"
#include "src/world/world_state.h"

namespace tumble::replay {

/// The bodies of a state as a scene has them. `known`: definitions from the scene and the throws, which hold what the
/// world does not keep (look and origin); a body that is not among them is made of the state's columns.
std::vector<sim::BoxDef> boxes_at(const sim::Bodies& bodies, std::vector<sim::BoxDef> known);

}  // namespace tumble::replay
