#pragma once

#include "src/base/result.h"
#include "src/world/world.h"

namespace tumble::sim {

/// Errors when the position, velocity or spin of body i is not finite or beyond limits.h, for grid sums are exact only
/// within them, or when its orientation is not of unit length. The message names the body, what was found and the
/// limit.
Status check_body(const Bodies& bodies, BodyIndex i);

/// The same for all bodies that move, the first that is wrong; in lanes, where the machine has them.
Status check_moving(const World& world);

/// Errors when a parameter of the stepper is out of range.
Status check_def(const WorldDef& def);

/// Friction 0 … kFrictionMax, restitution 0 … 1.
bool material_in_range(const Material& material);

/// The same for the outcome of one contact, before it enters a sum.
Status check_gain(const Bodies& bodies, BodyIndex i, const Vec3& velocity, const Vec3& spin);

/// Adds position and orientation of all bodies.
void hash_places(const World& world, Hasher& hasher);

/// Adds velocity and spin of all bodies.
void hash_velocities(const World& world, Hasher& hasher);

/// Adds both: what the phases that move bodies have written.
void hash_motion(const World& world, Hasher& hasher);

}  // namespace tumble::sim
