#pragma once

#include "src/kernels/contact_kernels.h"
#include "src/world/scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

enum class Direction { kUp, kDown };

/// Visits every manifold as often as its group says (once for restitution), layer by layer, the first time in this
/// direction, then to and fro. The manifolds of a layer all see the velocities from before it and their outcomes are
/// added up as grid doubles, so no order within the layer shows.
void sweep_layers(Scratch& scratch, Sweep sweep, Direction first, double substep_s);

/// Gives bodies the impulses that their contacts have from before.
void warm_start_layers(Scratch& scratch, double substep_s);

/// Whether an island with a slender body is to be solved.
bool has_slender(const Scratch& scratch);

}  // namespace tumble::sim
