#pragma once

#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/world/scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// Readies bodies and manifolds for the sub-steps: split masses, effective masses, friction centres, and the speed at
/// which each point will meet.
/// Reads:  velocity, spin, masses, frames; manifolds by layer
/// Writes: solver_bodies, in_contact, contact_batches
/// Source: mass splitting by Tonge, Benevolenski and Voroshilov (2012): within a layer a body in k manifolds lends each
///         of them a k-th of its mass, so that solving them all at the same time does not overshoot.
Status prepare_manifolds(WorldState& state, Scratch& scratch, double dt_s);
void hash_prepare_manifolds(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
