#pragma once

// What impacts take from the bodies and a bounce gives back, for any number of lanes. lane_vector.h says who may
// include this.

#include "src/kernels/contacts/contact_friction_impl.h"
#include "src/kernels/contacts/contact_lanes.h"

namespace tumble::sim {
namespace {

// The numbers on which the normal velocities of a manifold's points depend.
template <class V>
struct NormalMotion {
  V u, w1, w2;
};
template <class V, template <class> class B>
NormalMotion<V> normal_motion(const Manifolds<V, B>& m, const Motion<V>& motion) {
  return {dot(motion.u, m.n), dot(motion.w, m.t1), dot(motion.w, m.t2)};
}
template <class V>
NormalMotion<V> operator+(const NormalMotion<V>& x, const NormalMotion<V>& y) {
  return {x.u + y.u, x.w1 + y.w1, x.w2 + y.w2};
}
template <class V>
NormalMotion<V> operator-(const NormalMotion<V>& x, const NormalMotion<V>& y) {
  return {x.u - y.u, x.w1 - y.w1, x.w2 - y.w2};
}
template <class V>
PointSums<V> operator-(const PointSums<V>& x, const PointSums<V>& y) {
  return {x.s - y.s, x.sq - y.sq, x.sp - y.sp};
}

// The sum over the points of impulse times velocity.
template <class V>
V dot(const PointSums<V>& sums, const NormalMotion<V>& motion) {
  return motion.u * sums.s + (motion.w1 * sums.sq - motion.w2 * sums.sp);
}

template <class V, template <class> class B>
NormalMotion<V> motion_before(const Manifolds<V, B>& m, const ImpactBatch& impact) {
  return {m.get(impact.motion[0]), m.get(impact.motion[1]), m.get(impact.motion[2])};
}
template <class V, template <class> class B>
PointSums<V> sums_before(const Manifolds<V, B>& m, const ImpactBatch& impact) {
  return {m.get(impact.sums[0]), m.get(impact.sums[1]), m.get(impact.sums[2])};
}

// What friction has given the bodies since the impact's sweeps began, where it has; it takes energy on its way, but by
// the speeds before and after it may seem to give some, and the normal impulses to have taken as much more.
template <class V, template <class> class B>
V given_by_friction(const Manifolds<V, B>& m, const ImpactBatch& impact, const Motion<V>& motion) {
  const Friction<V> slip = slip_of(m, motion);
  const Friction<V> got = {m.get(m.batch->force1) - m.get(impact.forces[0]),
                           m.get(m.batch->force2) - m.get(impact.forces[1]),
                           m.get(m.batch->twist) - m.get(impact.forces[2])};
  const Friction<V> twice = {m.get(impact.slip[0]) + slip.force1, m.get(impact.slip[1]) + slip.force2,
                             m.get(impact.slip[2]) + slip.twist};
  return larger(V{}, 0.5 * dot(got, twice));
}

template <class V>
void begin_impact(const ContactWork& work, ImpactBatch& impact, unsigned at, bool has_impulses) {
  const ContactBatch& batch = work.batches[impact.batch];
  const Manifolds<V, EvenBody> m(work, work.batches[impact.batch], at);  // of any body, velocity and spin
  const Motion<V> all = relative_motion(m);
  const NormalMotion<V> motion = normal_motion(m, all);
  const Friction<V> slip = slip_of(m, all);
  const PointSums<V> sums = has_impulses ? sums_of_impulses(m) : PointSums<V>{};
  const V of_motion[3] = {motion.u, motion.w1, motion.w2}, of_sums[3] = {sums.s, sums.sq, sums.sp};
  const V of_slip[3] = {slip.force1, slip.force2, slip.twist};
  const Lanes* const forces[3] = {&batch.force1, &batch.force2, &batch.twist};
  for (int k = 0; k < 3; ++k) {
    m.set(impact.motion[k], of_motion[k]);
    m.set(impact.sums[k], of_sums[k]);
    m.set(impact.slip[k], of_slip[k]);
    m.set(impact.forces[k], has_impulses ? m.get(*forces[k]) : V{});
  }
}

template <class V>
void end_impact(const ContactWork& work, ImpactBatch& impact, unsigned at) {
  const Manifolds<V, EvenBody> m(work, work.batches[impact.batch], at);
  const Motion<V> motion = relative_motion(m);
  const NormalMotion<V> twice = normal_motion(m, motion) + motion_before(m, impact);
  const PointSums<V> got = sums_of_impulses(m) - sums_before(m, impact);
  const V given = 0.5 * dot(got, twice) + given_by_friction(m, impact, motion);
  m.set(impact.absorbed, m.get(impact.absorbed) - given);
}

template <class V>
void end_whole_impact(const ContactWork& work, ImpactBatch& impact, unsigned at) {
  const Manifolds<V, EvenBody> m(work, work.batches[impact.batch], at);
  const Motion<V> motion = relative_motion(m);
  const NormalMotion<V> now = normal_motion(m, motion);
  V largest = V{}, sum = V{}, works[kPointsMax];
  for (unsigned k = 0; k < m.batch->count; ++k) {
    const PointBatch& point = m.points[k];
    const V speed = now.u + (now.w1 * m.get(point.q) - now.w2 * m.get(point.p));
    works[k] = m.get(point.impulse) * (m.get(point.approach) + speed);
    largest = larger(largest, magnitude(works[k]));
  }
  const V magic = 3.0 * power_of_two(largest * terms_of(m));
  for (unsigned k = 0; k < m.batch->count; ++k) sum += to_grid(magic, works[k]);
  // Subtracted, so that a lane that is not used gets no negative zero.
  m.set(impact.absorbed, V{} - (0.5 * sum + given_by_friction(m, impact, motion)));
}

// The part of a visit's impulses with which a bounce gives back e² of the absorbed energy, where all of them would make
// it give back more. Newton's law of restitution alone adds energy where friction, or the step, turns the body during
// the impact (Stronge 1990). before: the sums of the impulses; pushed: the motion with all that the visit gives.
template <class V, template <class> class B>
V part_of_bounce(const ContactWork& work, const Manifolds<V, B>& m, const Motion<V>& motion,
                 const NormalMotion<V>& pushed, const PointSums<V>& before, const PointSums<V>& given) {
  const NormalMotion<V> now = normal_motion(m, motion);
  const ImpactBatch& impact = work.impacts[m.batch->impact];
  const V e = m.get(m.batch->restitution), zero = V{}, one = zero + 1.0;
  const NormalMotion<V> gain = pushed - now, twice = motion_before(m, impact) + now;
  const PointSums<V> got = before - sums_before(m, impact);
  // The bounce gives square t² + linear t + its work before this visit, for part t.
  const V square = 0.5 * dot(given, gain), linear = 0.5 * (dot(given, twice) + dot(got, gain));
  const V left =
      e * e * larger(zero, m.get(impact.absorbed)) - 0.5 * dot(got, twice) - given_by_friction(m, impact, motion);
  const V root = square_root(larger(zero, linear * linear + 4.0 * (square * left)));
  const V part = smaller(one, larger(zero, (root - linear) / (2.0 * square)));
  const auto too_much = (square > 0.0) & (square + linear > left);
  return too_much ? part : one;
}

}  // namespace
}  // namespace tumble::sim
