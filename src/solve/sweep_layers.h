#pragma once

#include "src/solve/contact_kernels.h"
#include "src/world/world.h"

namespace tumble::sim {

enum class Direction { kUp, kDown };

/// Visits every manifold once, layer by layer. The manifolds of a layer all see the velocities from before it and their
/// outcomes are added up as grid doubles, so no order within the layer shows.
void sweep_layers(World& world, Sweep sweep, Direction direction, double substep_s);

/// Gives bodies the impulses that their contacts have from before.
void warm_start_layers(World& world, double substep_s);

/// How often to sweep: impulses must find their way through the height of a stack, from 1 to 10 times.
int sweep_count(const Scratch& scratch);

}  // namespace tumble::sim
