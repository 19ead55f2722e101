#pragma once

// The levers of contacts, which turn with their bodies within a step, for any number of lanes. lane_vector.h says who
// may include this.

#include "src/kernels/contacts/contact_lanes.h"

namespace tumble::sim {
namespace {

/// rad. Levers of bodies that turn by less in a substep stay: a contact a metre away then errs by 10 µm, and bodies at
/// rest cost nothing. So do those of bodies that turn by more: a straight step would lengthen them.
constexpr double kLeverTurnMin = 1e-5, kLeverTurnMax = 0.25;

/// rad in a substep. Beyond it a light body answers otherwise, and passes with old responses would diverge.
constexpr double kResponseTurnMax = 0.02;

// The largest component of the turns of both bodies, rad.
template <class V>
V largest_of(const Space<V>& a, const Space<V>& b) {
  const auto of = [](const Space<V>& v) { return larger(magnitude(v.z), larger(magnitude(v.x), magnitude(v.y))); };
  return larger(of(a), of(b));
}

// Has `renew` compute the responses of these lanes anew.
template <class V, template <class> class B, class Mask>
void mark_turned(const Manifolds<V, B>& m, Mask turned) {
  constexpr unsigned kWidth = sizeof(V) / sizeof(double);
  alignas(64) double marks[kWidth];
  store(marks, turned ? V{} + 1.0 : V{});
  for (unsigned lane = 0; lane < kWidth; ++lane) {
    if (marks[lane] != 0) m.batch->turns = static_cast<std::uint8_t>(m.batch->turns | 1U << (m.at + lane));
  }
}

// Turns the levers of a contact for `time_s`, those of a with a and those of b with b. With levers of the step's start
// a crate on a turning table would be told to go on straight until the step ends, and creep outward. Directions stay:
// what holds does not depend on them. A slide leaves the levers as they are until the next step.
template <class V, template <class> class B>
void turn_levers(const Manifolds<V, B>& m, double time_s) {
  ContactBatch& batch = *m.batch;
  const Space<V> turn_a = m.a.spin * (V{} + time_s), turn_b = m.b.spin * (V{} + time_s);
  const V largest = largest_of(turn_a, turn_b);
  const auto turns = (largest > kLeverTurnMin) & (largest < kLeverTurnMax);
  if (!any(turns)) return;
  batch.levers_turned = true;
  mark_turned(m, turns & (largest > kResponseTurnMax));
  const V w1 = dot(turn_b, m.t1), w2 = dot(turn_b, m.t2), wn = dot(turn_b, m.n), offset = m.get(batch.offset);
  const auto turn_in_plane = [&](Lanes& to_p, Lanes& to_q) {
    const V p = m.get(to_p), q = m.get(to_q);
    m.set(to_p, turns ? p + (w2 * offset - wn * q) : p);
    m.set(to_q, turns ? q + (wn * p - w1 * offset) : q);
  };
  const V p = m.get(batch.centre_p), q = m.get(batch.centre_q);
  const Space<V> rb = (m.t1 * p + m.t2 * q) + m.n * offset, ra = rb + m.d;
  const Space<V> d = m.d + (cross(turn_a, ra) - cross(turn_b, rb));
  m.set(batch.d[0], turns ? d.x : m.d.x);
  m.set(batch.d[1], turns ? d.y : m.d.y);
  m.set(batch.d[2], turns ? d.z : m.d.z);
  m.set(batch.offset, turns ? offset + (w1 * q - w2 * p) : offset);
  turn_in_plane(batch.centre_p, batch.centre_q);
  for (unsigned k = 0; k < batch.count; ++k) turn_in_plane(m.points[k].p, m.points[k].q);
}

}  // namespace
}  // namespace tumble::sim
