#pragma once

#include "golden/hunt/scene/draws.h"
#include "tumble/sim/scene.h"

namespace tumble::hunt {

/// Adds bodies, ids ascending from the last one's, and what the arrangement needs of the world: gravity, ground.
using Arrange = void (*)(sim::SceneDef& scene, Draws& draws);

void arrange_stack(sim::SceneDef& scene, Draws& draws);       ///< boxes on top of one another
void arrange_wall(sim::SceneDef& scene, Draws& draws);        ///< courses of bricks
void arrange_heap(sim::SceneDef& scene, Draws& draws);        ///< boxes turned any way, dropped
void arrange_throw(sim::SceneDef& scene, Draws& draws);       ///< a stack that a box is thrown at
void arrange_slope(sim::SceneDef& scene, Draws& draws);       ///< crates on tilted ground or a tilted box
void arrange_spinners(sim::SceneDef& scene, Draws& draws);    ///< fast spins close beside ground and bodies
void arrange_ratios(sim::SceneDef& scene, Draws& draws);      ///< sizes, masses and speeds of any magnitude
void arrange_flight(sim::SceneDef& scene, Draws& draws);      ///< bodies that meet nothing
void arrange_ties(sim::SceneDef& scene, Draws& draws);        ///< boxes on a coarse lattice: exact ties everywhere
void arrange_collisions(sim::SceneDef& scene, Draws& draws);  ///< bodies that meet far from everything else
void arrange_overlaps(sim::SceneDef& scene, Draws& draws);    ///< boxes that begin inside others
void arrange_drop(sim::SceneDef& scene, Draws& draws);        ///< one box falls flat on the ground

}  // namespace tumble::hunt
