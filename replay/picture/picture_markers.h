#pragma once

#include "tumble/render/snapshot.h"
#include "tumble/sim/world.h"

/// Markers drawn over a picture: velocities, contacts, AABBs.
namespace tumble::replay {

/// Adds an arrow for each moving box, from its centre, as long as the box moves in `seconds`.
void add_velocity_markers(render::Snapshot& snapshot, double seconds);

/// Adds the contact points of the last substep that `world` took, each a small cube with an arrow along its normal.
void add_contact_markers(const sim::World& world, render::Snapshot& snapshot);

/// Adds the edges of each box's AABB, in the size that the broad phase computes before rounding.
void add_bounds_markers(render::Snapshot& snapshot);

}  // namespace tumble::replay
