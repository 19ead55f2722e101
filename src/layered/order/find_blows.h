#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Finds which bodies are hit: the points of a manifold approach faster than bodies at rest do. Whoever is hit from
/// below or, so that it tips, from the side, is *struck*; a hit from above is a *blow*, kept with its place. Fills
/// struck, blows and first_blow.
void find_blows(const Bodies& bodies, const Vec3& gravity, Scratch& scratch);

}  // namespace tumble::sim
