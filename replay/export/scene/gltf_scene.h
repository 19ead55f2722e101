#pragma once

#include "replay/export/plan/export_plan.h"
#include "replay/export/scene/gltf_buffer.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// Adds everything but the animation to `json`, and its numbers to `buffer`: scene, nodes, meshes, materials and
/// textures of the bodies, the ground, camera and light. Node i is body i of the plan; the others follow. Errors
/// (kCannotFinish): a texture cannot be encoded.
Status add_gltf_scene(const ExportPlan& plan, GltfBuffer& buffer, GltfJson& json);

}  // namespace tumble::replay
