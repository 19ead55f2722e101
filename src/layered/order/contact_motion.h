#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "src/kernels/contacts/contact_batch.h"
#include "src/layered/islands/awake_links.h"
#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

/// How the bodies of a manifold move past one another, and which of them is above.
namespace tumble::sim {

inline Vec3 velocity_of(const Bodies& bodies, BodyIndex i) {
  return moves(bodies, i) ? bodies.velocity[i] : Vec3(Vec3::Zero());
}
inline Vec3 spin_of(const Bodies& bodies, BodyIndex i) {
  return moves(bodies, i) ? bodies.spin[i] : Vec3(Vec3::Zero());
}

/// m/s at the centre of body b, as if it belonged to both bodies: b over a.
inline Vec3 velocity_across(const Bodies& bodies, const Manifold& m) {
  return (velocity_of(bodies, m.b) - velocity_of(bodies, m.a)) - cross(spin_of(bodies, m.a), m.d);
}

/// The speeds at which points part, of a manifold: u + (w1 q − w2 p).
struct Parting {
  double u, w1, w2;  ///< m/s; rad/s
  [[nodiscard]] double at(const ManifoldPoint& point) const { return u + (w1 * point.q - w2 * point.p); }
};
inline Parting parting_of(const Bodies& bodies, const Manifold& m) {
  const Vec3 w = spin_of(bodies, m.b) - spin_of(bodies, m.a);
  return {dot(velocity_across(bodies, m), m.n), dot(w, m.t1), dot(w, m.t2)};
}

/// Whether a point of the contact closes faster than that, m/s.
inline bool closes_by(const Bodies& bodies, const Scratch& scratch, const Manifold& m, double least) {
  const Parting parting = parting_of(bodies, m);
  const std::span<const ManifoldPoint> points = points_of(scratch, m);
  return std::ranges::any_of(points, [&](const ManifoldPoint& p) { return parting.at(p) < -least; });
}
/// Whether the bodies meet, and do not only rest on one another.
inline bool meets(const Bodies& bodies, const Scratch& scratch, const Manifold& m) {
  return closes_by(bodies, scratch, m, kRestingSpeed);
}

/// m/s², gravity along the normal, positive where b is above; 0 where the normal is so flat that neither supports.
inline double pull_along(const Vec3& gravity, const Manifold& m) {
  constexpr double kSteepest = 0.5;  // a contact supports if its normal takes this part of gravity or more
  const double pull = -dot(gravity, m.n);
  return std::fabs(pull) < kSteepest * length(gravity) ? 0 : pull;
}

/// How places are seen along gravity: metres aside in x and in y for one metre up; z is 1, or 0 beyond 60°, where they
/// are seen from above.
inline Vec3 tilt_of(const Vec3& gravity) {
  constexpr double kSteepest = 0.5;
  if (std::fabs(gravity.z()) < kSteepest * length(gravity) || gravity.z() == 0) return Vec3::Zero();
  return {gravity.x() / gravity.z(), gravity.y() / gravity.z(), 1};
}
/// m, a place seen along gravity; z is dropped.
inline Vec3 seen_along(const Vec3& tilt, const Vec3& place) {
  return {place.x() - place.z() * tilt.x(), place.y() - place.z() * tilt.y(), 0};
}

}  // namespace tumble::sim
