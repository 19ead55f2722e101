#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Prepares bodies and manifolds for the substeps: split masses, effective masses, friction centres, and the speed at
/// which each point will meet.
/// Reads:  velocity, spin, masses, frames; manifolds by layer
/// Writes: solver_bodies, in_contact, contact_batches
/// Source: mass splitting by Tonge, Benevolenski and Voroshilov (2012): within a layer each of a body's k manifolds
///         gets a k-th of the mass, so that solving all of them at one time does not overshoot.
Status prepare_manifolds(WorldState& state, Scratch& scratch, double dt_s);
void hash_prepare_manifolds(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
