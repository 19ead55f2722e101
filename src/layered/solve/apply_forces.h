#pragma once

#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/world/scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// Begins a sub-step: gravity, and the impulses that the contacts had in the last one (warm start).
/// Reads:  manifolds, points; gravity
/// Writes: solver_bodies' velocity and spin
/// Bodies without a manifold are left to finish_motion, which moves them exactly.
Status apply_forces(WorldState& state, Scratch& scratch, double substep_s);
void hash_apply_forces(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
