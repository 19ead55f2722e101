#pragma once

#include <algorithm>
#include <cmath>

#include "src/kernels/ground_contacts.h"
#include "src/thesis/contact_body.h"
#include "src/world/phase_scratch.h"
#include "tumble/sim/rotation.h"
#include "tumble/sim/vec.h"

/// Parts of collision_impulse.cc and share_load.cc.
namespace tumble::sim {

// How two bodies meet, and how they answer impulses along the normal and along the slip.
struct Meeting {
  double approach = 0;  // m/s along the normal, < 0
  double slip = 0;      // m/s along the tangent, >= 0
  double pull = 0;      // m/s of slip that gravity adds in one substep
  bool resting = false;
  bool slow = false;                           // whether the slip was slow before gravity acted, or turned round
  double normal_yield = 0, tangent_yield = 0;  // 1/kg
  // Of a patch: its mean radius, m, or 0 where nothing brakes a twist; the twist about the normal, rad/s, and its
  // answer to an angular impulse, 1/(kg·m²); the normal in the axes of both bodies.
  double radius = 0, twist = 0, twist_yield = 0;
  Turns normals;
};

struct Impulses {
  double normal = 0, friction = 0;  // N·s
  double twist = 0;                 // N·m·s at most, about the normal
};

inline Vec3 turn_of(const ContactBody& body, const Vec3& r, const Vec3& impulse) {
  if (body.inverse_mass == 0) return Vec3::Zero();
  return to_body(body.axes, cross(r, impulse));
}
inline Turns turns_of(const ContactBody& a, const ContactBody& b, const Vec3& impulse) {
  return {turn_of(a, a.r, impulse), turn_of(b, b.r, impulse)};
}

// x · I⁻¹ y, axes of the body.
inline double weighted(const Vec3& x, const Vec3& y, const Vec3& i) {
  return (x.x() * y.x() * i.x() + x.y() * y.y() * i.y()) + x.z() * y.z() * i.z();
}
// The parts of a spin gain along a direction of the body's axes.
inline double weighted(const Response& a, const Response& b, const Turns& direction, const Turns& turns) {
  return weighted(direction.a, turns.a, a.inverse_inertia) + weighted(direction.b, turns.b, b.inverse_inertia);
}

// The speed that a unit impulse along n at r gives the point along n by rotation: n · ((I⁻¹ (r × n)) × r), written as a
// sum of squares, so that the result is never negative.
inline double yield_of_rotation(const Vec3& lever, const Vec3& i) {
  return (lever.x() * lever.x() * i.x() + lever.y() * lever.y() * i.y()) + lever.z() * lever.z() * i.z();
}
inline double yield_of_rotation(const Response& a, const Response& b, const Turns& turns) {
  return yield_of_rotation(turns.a, a.inverse_inertia) + yield_of_rotation(turns.b, b.inverse_inertia);
}

inline Vec3 along_plane(const Vec3& v, const Vec3& normal) { return v - normal * dot(v, normal); }

// Equation 3.1 and Coulomb's bound; a patch that slips and twists at once divides the bound. At rest the part of the
// impulse that restitution adds does not press: III.E takes that part from the body again, for the height by which
// separation lifts the body.
inline Impulses impulses_of(const Meeting& m, const PairMaterial& material) {
  const double normal = -(1 + material.restitution) * m.approach / m.normal_yield;
  const double pressing = m.resting ? -m.approach / m.normal_yield : normal;
  const bool held = m.slow && m.pull <= material.friction * pressing * m.tangent_yield;
  const double most = (held ? material.friction : material.friction_dynamic) * pressing;
  const double to_stop = m.slip / m.tangent_yield;
  if (m.radius == 0) return {normal, std::min(to_stop, most)};
  const double stop_twist = std::fabs(m.twist) / m.twist_yield, at_rim = stop_twist / m.radius;
  const double wanted = std::sqrt(to_stop * to_stop + at_rim * at_rim), share = wanted > most ? most / wanted : 1;
  return {normal, to_stop * share, stop_twist * share};
}

}  // namespace tumble::sim
