#pragma once

#include "src/render/scene/snapshot.h"
#include "src/world/world.h"

/// What cannot be seen on a body's surface, drawn over the picture.
namespace tumble::replay {

/// An arrow for each box that moves, from its centre, as long as it goes in `seconds`.
void add_velocity_markers(render::Snapshot& snapshot, double seconds);

/// The contact points of the last sub-step that `world` took, each a small cube with an arrow along its normal.
void add_contact_markers(const sim::World& world, render::Snapshot& snapshot);

/// The edges of each box's AABB, as large as the broad phase has it before it rounds it.
void add_bounds_markers(render::Snapshot& snapshot);

}  // namespace tumble::replay
