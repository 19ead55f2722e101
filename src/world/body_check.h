#pragma once

#include <cmath>

#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/kernels/lane_width.h"
#include "src/model/limits.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// Finite, with every coordinate within ±limit. NaN fails every comparison, so the test is for what is wanted.
inline bool within(const Vec3& v, double limit) {
  return std::fabs(v.x()) <= limit && std::fabs(v.y()) <= limit && std::fabs(v.z()) <= limit;
}
/// While their sum is within a limit, all are, and it is quicker to find.
inline double magnitudes(const Vec3& v) { return (std::fabs(v.x()) + std::fabs(v.y())) + std::fabs(v.z()); }
/// True of nothing that check_body refuses, and quick.
inline bool far_within_limits(const Vec3& position, const Vec3& velocity, const Vec3& spin) {
  static_assert(kSpeedMax <= kPositionMax);
  return (magnitudes(position) + magnitudes(velocity)) + magnitudes(spin) <= kSpeedMax;
}
inline bool nearly_unit(const Quat& q) { return std::fabs(squared_length(q) - 1) <= kNormTolerance; }

/// What check_body and check_gain do where all is not far within the limits.
Status check_body_closely(const Bodies& bodies, BodyIndex i);
Status check_gain_closely(const Bodies& bodies, BodyIndex i, const Vec3& velocity, const Vec3& spin);

/// Errors when the position, velocity or spin of body i is not finite or beyond limits.h, for grid sums are exact only
/// within them, or when its orientation is not of unit length. The message names the body, what was found and the
/// limit.
inline Status check_body(const Bodies& bodies, BodyIndex i) {
  if (far_within_limits(bodies.position[i], bodies.velocity[i], bodies.spin[i]) && nearly_unit(bodies.orientation[i]))
      [[likely]]
    return {};
  return check_body_closely(bodies, i);
}

/// check_body for every body that moves; the error is that of the first wrong one. The columns are only read: the
/// kernels take pointers that others write through.
Status check_moving(Bodies& bodies, LaneWidth lanes);

/// Errors when a parameter of the stepper is out of range.
Status check_def(const WorldDef& def);

/// Friction 0 … kFrictionMax, restitution 0 … 1.
bool material_in_range(const Material& material);

/// The same for the outcome of one contact, before it enters a sum.
inline Status check_gain(const Bodies& bodies, BodyIndex i, const Vec3& velocity, const Vec3& spin) {
  if (magnitudes(velocity) + magnitudes(spin) <= kSpeedMax) [[likely]]
    return {};
  return check_gain_closely(bodies, i, velocity, spin);
}

/// Adds position and orientation of all bodies.
void hash_places(const Bodies& bodies, Hasher& hasher);

/// Adds velocity and spin of all bodies.
void hash_velocities(const Bodies& bodies, Hasher& hasher);

/// Adds both: what the phases that move bodies have written.
void hash_motion(const Bodies& bodies, Hasher& hasher);

}  // namespace tumble::sim
