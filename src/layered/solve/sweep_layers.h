#pragma once

#include "src/kernels/contact_kernels.h"
#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// The direction of a sweep through the layers: kUp starts at the ground.
enum class Direction { kUp, kDown };

/// Solves all layers (kPush: the layers hold, and fast pairs push) as often as their group says (once for restitution).
/// The first sweep goes in direction `first`, the next in the opposite direction, and so on. The manifolds of a layer
/// read the velocities from before the layer, and the layer adds up their outcomes as grid doubles, so the result does
/// not depend on the order within a layer.
void sweep_layers(Scratch& scratch, Sweep sweep, Direction first, double substep_s);

/// Sweeps the contacts `all`, whose work names other points and bodies than those of the step, so that overlaps part:
/// `more` times than the groups say.
void sweep_overlaps(Scratch& scratch, const ContactWork& all, int more);

/// Applies the impulses that the contacts already have.
void warm_start_layers(Scratch& scratch, double substep_s);

/// Solves the contacts of fast pairs; sweep_layers does so after every sweep, but not for restitution.
void solve_fast_layer(Scratch& scratch, Sweep sweep, double substep_s);

/// Whether one of the awake islands is hard.
bool has_hard(const Scratch& scratch);

}  // namespace tumble::sim
