#pragma once

#include "tumble/sim/hash.h"
#include "tumble/sim/scene.h"

namespace tumble::golden {

/// Hashes everything in a resolved scene that a session or its metrics depend on: world, steps, boxes with the table
/// they came from, inputs. Names, comments, textures, camera and light are not part of the hash.
Hash128 scene_hash(const sim::SceneDef& scene);

}  // namespace tumble::golden
