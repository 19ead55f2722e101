#pragma once

// How a body meets the ground, for any number of lanes: the operations of find_encounter, Meeting and share_load in
// src/thesis, in their order, without the terms of the ground, which are zero. lane_vector.h says who may include this.

#include "src/kernels/body_kernels_impl.h"
#include "src/kernels/ground_contacts.h"
#include "src/kernels/ground_points_impl.h"
#include "src/kernels/lanes/lane_vector.h"

namespace tumble::sim {
namespace {

template <class V>
using MaskOf = decltype(V{} < V{});

inline double gather(const double* column, const std::uint32_t* row, double /*like*/) { return column[row[0]]; }
inline Two gather(const double* column, const std::uint32_t* row, Two /*like*/) {
  return Two{column[row[0]], column[row[1]]};
}
#ifdef __AVX2__
inline Four gather(const double* c, const std::uint32_t* r, Four /*like*/) {
  return Four{c[r[0]], c[r[1]], c[r[2]], c[r[3]]};
}
#endif
#ifdef __AVX512F__
inline Eight gather(const double* c, const std::uint32_t* r, Eight /*like*/) {
  return Eight{c[r[0]], c[r[1]], c[r[2]], c[r[3]], c[r[4]], c[r[5]], c[r[6]], c[r[7]]};
}
#endif
template <class V>
Space<V> gather(const double* const (&columns)[3], const std::uint32_t* row) {
  return {gather(columns[0], row, V{}), gather(columns[1], row, V{}), gather(columns[2], row, V{})};
}

template <class V>
Space<V> scaled(const Space<V>& a, const Space<V>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <class V>
Space<V> divided(const Space<V>& a, V by) {
  return {a.x / by, a.y / by, a.z / by};
}
template <class V>
V length(const Space<V>& a) {
  return square_root(dot(a, a));
}
template <class V>
Space<V> along_plane(const Space<V>& v, const Space<V>& normal) {
  return v - normal * dot(v, normal);
}
template <class V>
Space<V> to_body(const Space<V> (&axes)[3], const Space<V>& v) {
  return {dot(axes[0], v), dot(axes[1], v), dot(axes[2], v)};
}
template <class V>
Space<V> to_world(const Space<V> (&axes)[3], const Space<V>& v) {
  return (axes[0] * v.x + axes[1] * v.y) + axes[2] * v.z;
}
template <class V>
V weighted(const Space<V>& x, const Space<V>& y, const Space<V>& i) {
  return (x.x * y.x * i.x + x.y * y.y * i.y) + x.z * y.z * i.z;
}

// The bodies of a collision with the ground, and the material of each pair.
template <class V>
struct LaneBody {
  LaneFrame<V> frame;
  Space<V> velocity, spin, inverse_inertia, r;
  V mass, inverse_mass, friction, friction_dynamic, restitution;

  LaneBody(const GroundCollisions& work, std::size_t at)
      : frame(work.frames, work.body + at),
        velocity(gather<V>(work.velocity, work.body + at)),
        spin(gather<V>(work.spin, work.body + at)),
        inverse_inertia(gather<V>(work.inverse_inertia, work.body + at)),
        r(load_space<V>(work.r, at)) {
    const std::uint32_t* const row = work.body + at;
    mass = gather(work.mass, row, V{});
    inverse_mass = gather(work.inverse_mass, row, V{});
    const V product = gather(work.friction, row, V{}) * work.ground_friction;
    const V dynamic = gather(work.friction_dynamic, row, V{}) * work.ground_friction_dynamic;
    friction = square_root(product);
    friction_dynamic = square_root(dynamic);
    restitution = larger(gather(work.restitution, row, V{}), V{} + work.ground_restitution);
  }
};

// As Encounter.
template <class V>
struct LaneEncounter {
  Space<V> relative, tangent, by_normal, by_tangent;
  V approach, slip, pull;
  MaskOf<V> rough, slow;

  LaneEncounter(const LaneBody<V>& body, const Space<V>& normal, const Space<V>& gained, double slip_speed_max) {
    const V zero = V{} + 0.0;
    const Space<V> none = {zero, zero, zero};
    relative = none - (body.velocity + cross(body.spin, body.r));
    approach = dot(relative, normal);
    by_normal = to_body(body.frame.axes, cross(body.r, normal));
    rough = (body.friction > 0.0) | (body.friction_dynamic > 0.0);
    const Space<V> slipping = along_plane(relative, normal), pulling = along_plane(gained, normal);
    const Space<V> slipping_before = slipping - pulling;
    const V speed = length(slipping);
    pull = rough ? length(pulling) : zero;
    const V speed_before = length(slipping_before), along = dot(slipping_before, slipping);
    slow = rough & ((speed_before < slip_speed_max) | (along < 0.0));
    const auto slips = rough & (speed > kSlipMin);
    slip = slips ? speed : zero;
    tangent = chosen(slips, divided(slipping, speed), none);
    by_tangent = chosen(slips, to_body(body.frame.axes, cross(body.r, tangent)), none);
  }
};

// As Meeting, without what the encounter holds and does not change.
template <class V>
struct LaneMeeting {
  V approach, slip, normal_yield, tangent_yield;
  MaskOf<V> slow;
  V radius = V{} + 0.0, twist = V{} + 0.0, twist_yield = V{} + 0.0;

  LaneMeeting(const LaneBody<V>& body, const LaneEncounter<V>& met)
      : approach(met.approach),
        slip(met.slip),
        normal_yield(body.inverse_mass + weighted(met.by_normal, met.by_normal, body.inverse_inertia)),
        tangent_yield(met.slip > 0.0
                          ? body.inverse_mass + weighted(met.by_tangent, met.by_tangent, body.inverse_inertia)
                          : V{} + 1.0),
        slow(met.slow) {}
};

// As Impulses.
template <class V>
struct LaneImpulses {
  V normal, friction, twist;
};

template <class V>
LaneImpulses<V> impulses_of(const LaneMeeting<V>& m, V pull, const LaneBody<V>& body, bool resting) {
  const V normal = -(1.0 + body.restitution) * m.approach / m.normal_yield;
  const V pressing = resting ? -m.approach / m.normal_yield : normal;
  const auto held = m.slow & (pull <= body.friction * pressing * m.tangent_yield);
  const V most = (held ? body.friction : body.friction_dynamic) * pressing;
  const V to_stop = m.slip / m.tangent_yield, zero = V{} + 0.0;
  LaneImpulses<V> found = {normal, smaller(to_stop, most), zero};
  const auto twists = m.radius != 0.0;
  if (!any(twists)) return found;
  const V stop_twist = absolute(m.twist) / m.twist_yield, at_rim = stop_twist / m.radius;
  const V wanted = square_root(to_stop * to_stop + at_rim * at_rim);
  const V share = wanted > most ? most / wanted : V{} + 1.0;
  found.friction = twists ? to_stop * share : found.friction;
  found.twist = twists ? stop_twist * share : zero;
  return found;
}

}  // namespace
}  // namespace tumble::sim
