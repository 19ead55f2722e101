#pragma once

#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/world/world.h"

namespace tumble::sim {

/// Begins a sub-step: gravity, and the impulses that the contacts had in the last one (warm start).
/// Reads:  manifolds, points; gravity
/// Writes: solver_bodies' velocity and spin
/// Bodies without a manifold are left to finish_motion, which moves them exactly.
Status apply_forces(World& world, double substep_s);
void hash_apply_forces(const World& world, Hasher& hasher);

}  // namespace tumble::sim
