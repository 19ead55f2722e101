#pragma once

// Friction of a manifold: a force along two tangents and a twist, for any number of lanes. lane_vector.h says who may
// include this.

#include "src/kernels/contacts/contact_lanes.h"

namespace tumble::sim {
namespace {

template <class V>
V clamped(V x, V limit) {
  return x < -limit ? -limit : (limit < x ? limit : x);
}

// Accumulated friction along t1 and t2, and about n.
template <class V>
struct Friction {
  V force1, force2, twist;
};

// Of all forces of size `size`, the one that comes nearest to stopping the slip: the slip that it leaves has the least
// energy (maximum dissipation), and the force opposes it. f: in the lanes of `slips` the force that would stop the
// slip, longer than `size`; m11, m12, m22: the masses that the tangents see. Lagrange's (1 + μ m) force = f, with
// Newton's method for 1 / |force|, which finds μ from below, at once where the masses are even.
template <class V, class Mask>
void cut_to_circle(V size, V m11, V m12, V m22, Mask slips, Friction<V>& f) {
  constexpr int kNewtonSteps = 4;
  constexpr double kNear = 1e-6;
  const V one = V{} + 1.0, tiny = V{} + 1e-300;
  V force1 = f.force1, force2 = f.force2;
  V length = square_root(larger(tiny, force1 * force1 + force2 * force2));
  const V goal = larger(size, length * 1e-9);  // of no friction at all, the direction
  const V apart = m11 - m22, heaviest = 0.5 * ((m11 + m22) + square_root(apart * apart + 4.0 * m12 * m12));
  V mu = (length / goal - one) / larger(tiny, heaviest);
  for (int k = 0; k < kNewtonSteps; ++k) {
    const V a = one + mu * m11, b = mu * m12, d = one + mu * m22, scale = one / (a * d - b * b);
    force1 = (d * f.force1 - b * f.force2) * scale;
    force2 = (a * f.force2 - b * f.force1) * scale;
    const V square = force1 * force1 + force2 * force2;
    length = square_root(larger(tiny, square));
    const auto far = slips & (length > goal * (1 + kNear));
    if (!any(far)) break;
    const V g1 = m11 * force1 + m12 * force2, g2 = m12 * force1 + m22 * force2;
    const V fall = (force1 * (d * g1 - b * g2) + force2 * (a * g2 - b * g1)) * scale;
    mu = far ? mu + (length / goal - one) * square / larger(tiny, fall) : mu;
  }
  f.force1 = slips ? force1 * (size / length) : f.force1;
  f.force2 = slips ? force2 * (size / length) : f.force2;
}

// Cuts the force to the cone of friction. A contact that has slipped in this substep keeps the dynamic coefficient
// until the substep ends; otherwise it would stick and slip by turns from sweep to sweep.
template <class V, template <class> class B>
void cut_force(const Manifolds<V, B>& m, V pressure, const V inverse[6], Friction<V>& f) {
  ContactBatch& batch = *m.batch;
  const V sliding = m.get(batch.sliding), one = V{} + 1.0;
  const V dynamic = m.get(batch.friction_dynamic) * pressure;
  const V limit = sliding == one ? dynamic : m.get(batch.friction) * pressure;
  const auto slips = f.force1 * f.force1 + f.force2 * f.force2 > limit * limit;
  if (!any(slips)) return;
  m.set(batch.sliding, slips ? one : sliding);
  cut_to_circle(dynamic, inverse[0], inverse[1], inverse[3], slips, f);
}

// Force and twist within their limits, from those that together would stop slip and spin. Where one is cut, the other
// takes what is best with that: a force that counts on a twist which a single point cannot give would push along the
// slip. inverse: of the matrix of (t1, t2, twist), as friction_inverse.
template <class V, template <class> class B>
Friction<V> within_limits(const Manifolds<V, B>& m, V pressure, const Friction<V>& stop, const V inverse[6]) {
  const V twist_limit = m.get(m.batch->friction) * pressure * m.get(m.batch->radius);
  Friction<V> f = stop;
  f.twist = clamped(stop.twist, twist_limit);
  if (any_differ(f.twist, stop.twist)) {
    const auto cut = f.twist != stop.twist;
    const V missing = (f.twist - stop.twist) / inverse[5];
    f.force1 = cut ? stop.force1 + inverse[2] * missing : stop.force1;
    f.force2 = cut ? stop.force2 + inverse[4] * missing : stop.force2;
  }
  cut_force(m, pressure, inverse, f);
  const V moved = magnitude(f.force1 - stop.force1) + magnitude(f.force2 - stop.force2);
  if (!any_above(moved, V{})) return f;
  const V scale = 1.0 / (inverse[0] * inverse[3] - inverse[1] * inverse[1]);
  const V along1 = (inverse[3] * inverse[2] - inverse[1] * inverse[4]) * scale;
  const V along2 = (inverse[0] * inverse[4] - inverse[1] * inverse[2]) * scale;
  const V twist = stop.twist + (along1 * (f.force1 - stop.force1) + along2 * (f.force2 - stop.force2));
  f.twist = moved == 0.0 ? f.twist : clamped(twist, twist_limit);
  return f;
}

// The friction impulse that stops the slip, cut to what the normal impulses allow; returns the change as a wrench.
template <class V, template <class> class B>
Wrench<V> solve_friction(const Manifolds<V, B>& m, const Motion<V>& motion, V pressure) {
  ContactBatch& batch = *m.batch;
  const V offset = m.get(batch.offset), p = m.get(batch.centre_p), q = m.get(batch.centre_q);
  const V w1 = dot(motion.w, m.t1), w2 = dot(motion.w, m.t2), wn = dot(motion.w, m.n);
  const V u1 = dot(motion.u, m.t1) + (w2 * offset - wn * q);
  const V u2 = dot(motion.u, m.t2) + (wn * p - w1 * offset);
  V f[6];
  for (int k = 0; k < 6; ++k) f[k] = m.get(batch.friction_inverse[k]);
  const V before1 = m.get(batch.force1), before2 = m.get(batch.force2), twist_before = m.get(batch.twist);
  const Friction<V> stop = {before1 - ((f[0] * u1 + f[1] * u2) + f[2] * wn),
                            before2 - ((f[1] * u1 + f[3] * u2) + f[4] * wn),
                            twist_before - ((f[2] * u1 + f[4] * u2) + f[5] * wn)};
  const Friction<V> now = within_limits(m, pressure, stop, f);
  const V d1 = now.force1 - before1, d2 = now.force2 - before2;
  m.set(batch.force1, now.force1);
  m.set(batch.force2, now.force2);
  m.set(batch.twist, now.twist);
  return friction_wrench(m, d1, d2, (now.twist - twist_before) + (p * d2 - q * d1));
}

}  // namespace
}  // namespace tumble::sim
