#pragma once

// The impulses that a substep begins with, for any number of lanes. lane_vector.h says who may include this.

#include "src/kernels/contacts/contact_lanes.h"

namespace tumble::sim {
namespace {

// An impulse that stopped a hit has done its work: the next substep would throw the bodies apart with it. Of what is
// more than the contact bears, a substep begins with some times what stops the bodies where they are pressed. sums: of
// all points.
template <class V, template <class> class B>
void pass_on_less(const Manifolds<V, B>& m, const PointSums<V>& sums) {
  const V zero = V{}, one = zero + 1.0, borne = m.get(m.batch->passes_on);
  const auto hit = sums.s > borne;
  const V all = hit ? sums.s : one, p = sums.sp / all, q = sums.sq / all;
  V r[6];
  for (int k = 0; k < 6; ++k) r[k] = m.get(m.batch->response[k]);
  const V yield = (r[0] + 2.0 * (q * r[1] + p * r[2])) + (((q * q) * r[3] - (p * p) * r[5]) + 2.0 * ((p * q) * r[4]));
  const Motion<V> motion = relative_motion(m);
  const V parting = dot(motion.u, m.n) + (dot(motion.w, m.t1) * q - dot(motion.w, m.t2) * p);
  Lanes stops;
  for (unsigned lane = 0; lane < kLanes; ++lane) stops.of[lane] = (m.batch->loose >> lane & 1U) != 0 ? 0 : kHitStops;
  const V stopping = m.get(stops) * (larger(zero, -parting) / (hit ? yield : one));
  const V part = hit ? smaller(all, larger(borne, stopping)) / all : one;
  for (unsigned k = 0; k < m.batch->count; ++k) m.set(m.points[k].impulse, part * m.get(m.points[k].impulse));
  Lanes* const frictions[] = {&m.batch->force1, &m.batch->force2, &m.batch->twist};
  for (Lanes* const friction : frictions) m.set(*friction, part * m.get(*friction));
}

template <class V, template <class> class B>
void warm_start_from(const ContactWork& work, ContactBatch& batch, unsigned at) {
  const Manifolds<V, B> m(work, batch, at);
  PointSums<V> sums = sums_of_impulses(m);
  if (any_above(sums.s, m.get(batch.passes_on))) {
    pass_on_less(m, sums);
    sums = sums_of_impulses(m);
  }
  m.set(batch.sliding, V{});
  const V force1 = m.get(batch.force1), force2 = m.get(batch.force2);
  const V turn = m.get(batch.twist) + (m.get(batch.centre_p) * force2 - m.get(batch.centre_q) * force1);
  const Wrench<V> normal = normal_wrench(m, sums.s, sums.sq, sums.sp),
                  friction = friction_wrench(m, force1, force2, turn);
  write_outcomes(work, m, {normal.force + friction.force, normal.torque + friction.torque});
}

template <class V>
void warm_start(const ContactWork& work, ContactBatch& batch, unsigned at) {
  return batch.even ? warm_start_from<V, EvenBody>(work, batch, at) : warm_start_from<V, Body>(work, batch, at);
}

}  // namespace
}  // namespace tumble::sim
