#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Finds which bodies are hit: the points of a manifold approach faster than bodies at rest do. Whoever is hit from
/// below or, so that it tips, from the side, is *struck*; a hit from above is a *blow*, kept with its place. Fills
/// struck, blows and first_blow. The caller has cleared struck and first_blow; workers meet in it.
void find_blows(const Bodies& bodies, const Vec3& gravity, Scratch& scratch, const Worker& worker);

}  // namespace tumble::sim
