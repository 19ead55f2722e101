#pragma once

#include "tumble/sim/scene.h"
#include "tumble/sim/vec.h"

/// Movements of a camera by hand. The focus keeps its share of the distance to the target.
namespace tumble::render {

/// Turns the camera about its target: to the right around the vertical, and up, in degrees. `ground`: the eye stays
/// above the plane z = 0.
void orbit(sim::Camera& camera, double right_degrees, double up_degrees, bool ground);

/// Moves eye and target together, sideways and up on the picture, in heights of the picture at the target's distance.
void pan(sim::Camera& camera, double right, double up);

/// Multiplies the distance to the target, within 0.1 m … 10 km.
void zoom(sim::Camera& camera, double factor);

/// Moves eye and target by `shift`, m.
void shift(sim::Camera& camera, const sim::Vec3& shift);

}  // namespace tumble::render
