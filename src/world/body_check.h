#pragma once

#include <cmath>
#include <string>

#include "src/kernels/lane_width.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/limits.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Whether every coordinate is finite and within ±limit. NaN fails every comparison, so the test asks for the good
/// case.
inline bool within(const Vec3& v, double limit) {
  return std::fabs(v.x()) <= limit && std::fabs(v.y()) <= limit && std::fabs(v.z()) <= limit;
}
/// The sum of the magnitudes: a bound of each, in one comparison.
inline double magnitudes(const Vec3& v) { return (std::fabs(v.x()) + std::fabs(v.y())) + std::fabs(v.z()); }
/// Whether one quick test shows that check_body would accept position, velocity and spin; false leaves that open.
inline bool far_within_limits(const Vec3& position, const Vec3& velocity, const Vec3& spin) {
  static_assert(kSpeedMax <= kPositionMax);
  return (magnitudes(position) + magnitudes(velocity)) + magnitudes(spin) <= kSpeedMax;
}
inline bool nearly_unit(const Quat& q) { return std::fabs(squared_length(q) - 1) <= kNormTolerance; }

/// "found <quantity> <found>, wanted finite and within ±limit".
std::string beyond_text(const char* quantity, const Vec3& found, double limit, const char* unit);
/// "<body>: " and that, and advice.
Error beyond(const std::string& body, const char* quantity, const Vec3& found, double limit, const char* unit);

/// The exact tests of check_body and check_gain, for bodies that are not far within the limits.
Status check_body_closely(const Bodies& bodies, BodyIndex i);
Status check_gain_closely(const Bodies& bodies, BodyIndex i, const Vec3& velocity, const Vec3& spin);

/// Errors: position, velocity or spin of body i is not finite or beyond limits.h (grid sums are exact only within
/// those), or the orientation has not unit length. The message names the body, the value found and the limit.
inline Status check_body(const Bodies& bodies, BodyIndex i) {
  if (far_within_limits(bodies.position[i], bodies.velocity[i], bodies.spin[i]) && nearly_unit(bodies.orientation[i]))
      [[likely]]
    return {};
  return check_body_closely(bodies, i);
}

/// check_body for every body that is neither frozen nor static; the error is that of the first wrong body. Reads the
/// columns only: they are not const because the kernels share one kind of pointers.
Status check_moving(Bodies& bodies, LaneWidth lanes);

/// Errors: a parameter of the stepper is out of range.
Status check_def(const WorldDef& def);

/// Whether friction is 0 … kFrictionMax and restitution 0 … 1.
bool material_in_range(const Material& material);
/// What an error says of one that is not.
std::string out_of_range(const Material& material);

/// Errors: the gain of body i from one contact is not finite or beyond limits.h; asked before the gain enters a sum.
inline Status check_gain(const Bodies& bodies, BodyIndex i, const Vec3& velocity, const Vec3& spin) {
  if (magnitudes(velocity) + magnitudes(spin) <= kSpeedMax) [[likely]]
    return {};
  return check_gain_closely(bodies, i, velocity, spin);
}

Status check_gains_closely(const Bodies& bodies, BodyIndex i, double total);

/// Errors: the gains of body i, whose largest parts add up to `total`, are beyond kGainTotalMax.
inline Status check_gains(const Bodies& bodies, BodyIndex i, double total) {
  if (total <= kGainTotalMax) [[likely]]
    return {};
  return check_gains_closely(bodies, i, total);
}

/// Adds velocity and spin of the frozen bodies to the hash.
void hash_frozen_velocities(const Bodies& bodies, Hasher& hasher);

/// Bodies of a block: the hash gets their columns of position, orientation, velocity and spin, then the next block's.
inline constexpr std::size_t kMotionsABlock = 256;

/// Adds one block, [begin, end).
void add_motion(const Bodies& bodies, std::size_t begin, std::size_t end, Hasher& hasher);

/// Adds position, orientation, velocity and spin of all bodies to the hash, block by block.
void hash_motion(const Bodies& bodies, Hasher& hasher);

}  // namespace tumble::sim
