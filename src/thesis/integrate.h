#pragma once

#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/kernels/body_kernels.h"
#include "src/world/world.h"

namespace tumble::sim {

/// Free flight for dt_s of every body that moves.
/// Reads:  position, orientation, velocity, spin, inertia; gravity, air_drag
/// Writes: position, orientation, velocity, spin
/// Errors: a body that is not finite or beyond limits.h
/// Source: ballistic rule x += ½ (v₀ + v₁) dt, exact under gravity. Rotation: implicit midpoint in the body's frame
///         with a Cayley map (Austin, Krishnaprasad and Wang 1993): it keeps angular momentum and kinetic energy, and
///         needs no trigonometry; solved by Newton's method, which bars need. The thesis says only "basic integration"
///         by Baraff and Witkin.
Status integrate(World& world, double dt_s);
void hash_integrate(const World& world, Hasher& hasher);

/// What free flight for dt_s makes of body i.
struct Flight {
  Vec3 position;
  Quat orientation;
  Vec3 velocity, spin;
};
Flight free_flight(const WorldState& state, BodyIndex i, double dt_s);
/// Lets bodies fly that move and are not `in_contact` (null: none is).
void fly_freely(World& world, Rows rows, const std::uint8_t* in_contact, double dt_s);

/// The part of integrate that turns one body: new orientation, and the spin that keeps R I Rᵀ w. Exposed for tests.
struct Rotation {
  Quat orientation;
  Vec3 spin;
};
/// A cube or the like, whose spin stays as it is.
inline bool turns_evenly(const Vec3& inertia) { return inertia.x() == inertia.y() && inertia.y() == inertia.z(); }
/// What does not.
Rotation rotate_unevenly(const Quat& orientation, const Vec3& spin, const Vec3& inertia, const Vec3& inverse_inertia,
                         double dt_s);
inline Rotation rotate_freely(const Quat& orientation, const Vec3& spin, const Vec3& inertia,
                              const Vec3& inverse_inertia, double dt_s) {
  if (turns_evenly(inertia)) {
    return {rotated_by_half(orientation, spin * (0.5 * dt_s)), spin};
  }
  return rotate_unevenly(orientation, spin, inertia, inverse_inertia, dt_s);
}

}  // namespace tumble::sim
