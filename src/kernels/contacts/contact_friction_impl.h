#pragma once

// Friction of a manifold: a force along two tangents and a twist, for any number of lanes. lane_vector.h says who may
// include this.

#include "src/kernels/contacts/contact_lanes.h"

namespace tumble::sim {
namespace {

// Accumulated friction along t1 and t2, and about n; or a slip along them.
template <class V>
struct Friction {
  V force1, force2, twist;
};
template <class V>
V dot(const Friction<V>& a, const Friction<V>& b) {
  return (a.force1 * b.force1 + a.force2 * b.force2) + a.twist * b.twist;
}

// A symmetric 3 × 3 matrix of (t1, t2, twist): 11, 12, 13, 22, 23, 33.
template <class V>
struct FrictionMatrix {
  V of[6];

  Friction<V> times(const Friction<V>& x) const {
    return {(of[0] * x.force1 + of[1] * x.force2) + of[2] * x.twist,
            (of[1] * x.force1 + of[3] * x.force2) + of[4] * x.twist,
            (of[2] * x.force1 + of[4] * x.force2) + of[5] * x.twist};
  }
  // x, where this matrix times x is -y.
  Friction<V> against(const Friction<V>& y) const {
    const V c11 = of[3] * of[5] - of[4] * of[4], c22 = of[0] * of[5] - of[2] * of[2];
    const V c12 = of[2] * of[4] - of[1] * of[5], c13 = of[1] * of[4] - of[2] * of[3];
    const V c33 = of[0] * of[3] - of[1] * of[1], c23 = of[1] * of[2] - of[0] * of[4];
    const FrictionMatrix cofactors = {{c11, c12, c13, c22, c23, c33}};
    const V scale = -1.0 / (of[5] * c33 + (of[2] * c13 + of[4] * c23));
    const Friction<V> x = cofactors.times(y);
    return {x.force1 * scale, x.force2 * scale, x.twist * scale};
  }
};

// Normal impulses of a manifold's points: their sum, and the largest.
template <class V>
struct Pressure {
  V sum, most;
};

// 1 / √x by Newton's method, from an estimate of the bits. Two iterations leave 5e-6 of it, three 4e-11, four the
// rounding: for the few lanes of a vector far less time than a root and a division.
template <int kIterations, class V>
V inverse_root(V x) {
  const V half = 0.5 * x;
  V y = inverse_root_estimate(x);
  for (int k = 0; k < kIterations; ++k) y = y * (1.5 - (half * y) * y);
  return y;
}

// Coulomb's cones at the points of a manifold.
template <class V, template <class> class B>
class Cones {
 public:
  Cones(const Manifolds<V, B>& m, const Pressure<V>& pressure, V coefficient)
      : m_(m), p_(m.get(m.batch->centre_p)), q_(m.get(m.batch->centre_q)), coefficient_(coefficient) {
    const V terms = terms_of(m);
    for (unsigned k = 0; k < m.batch->count; ++k) {
      reach_ = larger(reach_, where_pressed(k, larger(magnitude(p(k)), magnitude(q(k)))));
      viscous_[k] = V{};
    }
    most_ = pressure.most * terms;
  }

  // Sets how the points slip where the centre slips by `d`, and the sum of impulse times slip.
  template <int kIterations>
  void slip(const Friction<V>& d) {
    const V magic = grid_of(most_ * ((magnitude(d.force1) + magnitude(d.force2)) + 2.0 * reach_ * magnitude(d.twist)));
    work_ = V{};
    shortest_ = V{} + kStill;
    for (unsigned k = 0; k < m_.batch->count; ++k) {
      const V along1 = slip1_[k] = d.force1 - d.twist * q(k), along2 = slip2_[k] = d.force2 + d.twist * p(k);
      const V square = along1 * along1 + along2 * along2;
      const V per_speed = per_speed_[k] = inverse_root<kIterations>(larger(V{} + 1.0 / (kStill * kStill), square));
      const V impulse = m_.get(m_.points[k].impulse);
      shortest_ = smaller(shortest_, impulse > 0.0 ? per_speed : shortest_);
      work_ += to_grid(magic, impulse * (square * per_speed));
    }
  }
  V work() const { return work_; }

  // Adds to `matrix` the cones as if they were viscous: at one in `per_part` of the slip each gives all that it can.
  // Lanes outside `going` keep theirs.
  template <class Mask>
  void add_viscous(V per_part, Mask going, FrictionMatrix<V>& matrix) {
    constexpr double kSlowest = 1e6;  // the fastest point is as many times as fast as one that hardly slips
    const V longest = shortest_ * kSlowest;
    V largest = V{};
    for (unsigned k = 0; k < m_.batch->count; ++k) {
      const V impulse = m_.get(m_.points[k].impulse);
      const V viscous = (coefficient_ * per_part) * (impulse * smaller(longest, per_speed_[k]));
      viscous_[k] = going ? viscous : viscous_[k];
      largest = larger(largest, viscous_[k]);
    }
    largest = largest * terms_of(m_);
    const V magic = grid_of(largest), magic_1 = grid_of(largest * reach_),
            magic_2 = grid_of(2.0 * (largest * (reach_ * reach_)));
    V sum = V{}, sum_p = V{}, sum_q = V{}, sum_2 = V{};
    for (unsigned k = 0; k < m_.batch->count; ++k) {
      const V here = viscous_[k], x = p(k), y = q(k);
      sum += to_grid(magic, here);
      sum_p += to_grid(magic_1, here * x);
      sum_q += to_grid(magic_1, here * y);
      sum_2 += to_grid(magic_2, here * (x * x + y * y));
    }
    V* const of = matrix.of;
    of[0] += sum;
    of[2] -= sum_q;
    of[3] += sum;
    of[4] += sum_p;
    of[5] += sum_2;
  }

  // Friction against the last slip, by the last add_viscous; no point gives more than it can.
  Friction<V> friction() const {
    const V most = coefficient_ * most_, magic = grid_of(most), magic_1 = grid_of(2.0 * (most * reach_));
    Friction<V> f = {V{}, V{}, V{}};
    for (unsigned k = 0; k < m_.batch->count; ++k) {
      const V most_here = (coefficient_ * m_.get(m_.points[k].impulse)) * per_speed_[k];
      const V here = smaller(viscous_[k], most_here);
      const V force1 = here * slip1_[k], force2 = here * slip2_[k];
      f.force1 -= to_grid(magic, force1);
      f.force2 -= to_grid(magic, force2);
      f.twist -= to_grid(magic_1, p(k) * force2 - q(k) * force1);
    }
    return f;
  }

 private:
  V p(unsigned point) const { return m_.get(m_.points[point].p) - p_; }
  V q(unsigned point) const { return m_.get(m_.points[point].q) - q_; }
  // Other manifolds of the batch may have points that this one lacks; those have no impulse.
  V where_pressed(unsigned point, V value) const { return m_.get(m_.points[point].impulse) > 0.0 ? value : V{}; }
  // Magic number of a grid on which sums are exact whose magnitudes add up to no more.
  static V grid_of(V magnitudes) { return 3.0 * power_of_two(magnitudes); }

  const Manifolds<V, B>& m_;
  V p_, q_, coefficient_;
  static constexpr double kStill = 1e150;  // s/m: how long a point that stands still takes for a metre

  V reach_ = V{}, most_ = V{}, work_ = V{}, shortest_ = V{};  // shortest_: s/m, of the fastest point
  V slip1_[kPointsMax], slip2_[kPointsMax], per_speed_[kPointsMax], viscous_[kPointsMax];
};

// Of all frictions that the points can give, each within its cone, the one that leaves the slip with the least energy
// (maximum dissipation). Its slip d minimises ½ d·A d + stop·d + Σ μλ |slip of the point|, A the inverse of the
// response; each round puts a parabola that touches from above in the place of each |slip|, and first finds the best
// multiple of d. Of the slip of a round nothing is kept but how the points slip, so the force is within the cones after
// any number of rounds. stop: friction that would stop all slip. Lanes where the points can give it keep it.
template <class V, template <class> class B, class Mask>
Friction<V> cut_to_cones(const Manifolds<V, B>& m, const Pressure<V>& pressure, const FrictionMatrix<V>& inverse,
                         const Friction<V>& stop, Mask asked) {
  constexpr int kRounds = 3, kRough = 2, kExact = 4;  // rounds; iterations for 5e-6 of a speed and for all its digits
  constexpr double kLeastPart = 0.3;
  constexpr double kNear = 1e-6;  // of a square: a round that turns the slip by a thousandth at most was the last
  ContactBatch& batch = *m.batch;
  const V sliding = m.get(batch.sliding), one = V{} + 1.0, dynamic = m.get(batch.friction_dynamic);
  const V holds = sliding == one ? dynamic : m.get(batch.friction);
  Cones<V, B> cones(m, pressure, dynamic);
  Friction<V> d = inverse.against(stop);
  const auto pressed = pressure.most > 0.0;
  auto going = asked & pressed;  // without pressure there is no friction, whatever the slip is
  for (int round = 0; round < kRounds && any(going); ++round) {
    cones.template slip<kRough>(d);
    const V gain = -(dot(stop, d) + dynamic * cones.work()), stiff = dot(d, inverse.times(d));
    FrictionMatrix<V> matrix = inverse;
    cones.add_viscous(stiff / larger(kLeastPart * stiff, gain), going, matrix);
    const Friction<V> next = matrix.against(stop);
    const V part = gain / stiff;
    const Friction<V> turned = {next.force1 - part * d.force1, next.force2 - part * d.force2,
                                next.twist - part * d.twist};
    d = {going ? next.force1 : d.force1, going ? next.force2 : d.force2, going ? next.twist : d.twist};
    going = going & (dot(turned, inverse.times(turned)) > kNear * dot(next, inverse.times(next)));
  }
  const bool any_pressed = any(asked & pressed);
  if (any_pressed) cones.template slip<kExact>(d);
  const auto slips = asked & (dot(stop, d) + holds * cones.work() < 0.0);
  if (!any(slips)) return stop;
  m.set(batch.sliding, slips ? one : sliding);
  Friction<V> f = {V{}, V{}, V{}};
  if (any_pressed) f = cones.friction();
  return {slips ? f.force1 : stop.force1, slips ? f.force2 : stop.force2, slips ? f.twist : stop.twist};
}

// The lanes where it has to be asked whether the points can give `stop`. In the others each gives its impulse times a
// motion in the plane that is the same for all, the fastest of these well below the coefficient: cut_to_cones would cut
// none of them, so this decides nothing but how long it takes.
template <class V, template <class> class B, class Mask>
auto doubtful(const Manifolds<V, B>& m, const Friction<V>& stop, V coefficient, Mask flat) {
  constexpr double kWellBelow = 0.999, kSpread = 1e-6;
  const V centre_p = m.get(m.batch->centre_p), centre_q = m.get(m.batch->centre_q), zero = V{};
  V p[kPointsMax], q[kPointsMax], impulse[kPointsMax];
  V sum = zero, sum_p = zero, sum_q = zero, sum_2 = zero;
  for (unsigned k = 0; k < m.batch->count; ++k) {
    p[k] = m.get(m.points[k].p) - centre_p;
    q[k] = m.get(m.points[k].q) - centre_q;
    impulse[k] = m.get(m.points[k].impulse);
    sum += impulse[k];
    sum_p += impulse[k] * p[k];
    sum_q += impulse[k] * q[k];
    sum_2 += impulse[k] * (p[k] * p[k] + q[k] * q[k]);
  }
  const V each = 1.0 / sum, mean_p = sum_p * each, mean_q = sum_q * each;
  const V spread = sum_2 - (mean_p * sum_p + mean_q * sum_q);
  const V twist = stop.twist - (mean_p * stop.force2 - mean_q * stop.force1);
  const V turn = flat ? twist / spread : zero;
  const V along1 = stop.force1 * each + turn * mean_q, along2 = stop.force2 * each - turn * mean_p;
  V fastest = zero;
  for (unsigned k = 0; k < m.batch->count; ++k) {
    const V at1 = along1 - turn * q[k], at2 = along2 + turn * p[k];
    fastest = larger(fastest, impulse[k] > 0.0 ? at1 * at1 + at2 * at2 : zero);
  }
  const V most = coefficient * kWellBelow;
  return (sum <= 0.0) | (flat & (spread <= kSpread * sum_2)) | (fastest > most * most);
}

// Friction within the cones of the points, from the one that would stop slip and spin. A contact that has slipped in
// this substep keeps the dynamic coefficient until the substep ends; otherwise it would stick and slip by turns from
// sweep to sweep. A single point gives no twist; a force that counts on one would push along the slip.
template <class V, template <class> class B, class Mask>
Friction<V> within_limits(const Manifolds<V, B>& m, const Pressure<V>& pressure, Friction<V> stop,
                          FrictionMatrix<V> inverse, Mask rubs) {
  constexpr double kSurely = 0.25, kEven = 0.75;
  const V radius = m.get(m.batch->radius), zero = V{}, one = zero + 1.0;
  const auto flat = radius > 0.0;
  if (!all_of(flat)) {
    const V* const of = inverse.of;
    const V per_twist = 1.0 / larger(zero + 1e-300, of[5]), x = of[2] * per_twist, y = of[4] * per_twist;
    stop.force1 = flat ? stop.force1 : stop.force1 - x * stop.twist;
    stop.force2 = flat ? stop.force2 : stop.force2 - y * stop.twist;
    stop.twist = flat ? stop.twist : zero;
    // t1 and t2 may change places: each product of two entries is one, whichever comes first.
    inverse = {{flat ? of[0] : of[0] - x * of[2], flat ? of[1] : of[1] - per_twist * (of[2] * of[4]),
                flat ? of[2] : zero, flat ? of[3] : of[3] - y * of[4], flat ? of[4] : zero, of[5]}};
  }
  // Without asking each point: none bears more than three quarters, and the friction is a quarter of the most.
  const V coefficient = m.get(m.batch->sliding) == one ? m.get(m.batch->friction_dynamic) : m.get(m.batch->friction);
  const V arm = flat ? radius : one, limit = coefficient * pressure.sum * (flat ? arm * kSurely : one);
  const V force = (stop.force1 * stop.force1 + stop.force2 * stop.force2) * (arm * arm);
  auto asked =
      rubs & ((force + stop.twist * stop.twist > limit * limit) | (flat & (pressure.most > kEven * pressure.sum)));
  if (!any(asked)) return stop;
  const V most = coefficient * pressure.sum, wanted = stop.force1 * stop.force1 + stop.force2 * stop.force2;
  const auto pressed = pressure.most > 0.0;
  if (!any(asked & (pressed & (wanted > most * most)))) asked = asked & doubtful(m, stop, coefficient, flat);
  return any(asked) ? cut_to_cones(m, pressure, inverse, stop, asked) : stop;
}

// How the centre of friction slips.
template <class V, template <class> class B>
Friction<V> slip_of(const Manifolds<V, B>& m, const Motion<V>& motion) {
  const V offset = m.get(m.batch->offset), p = m.get(m.batch->centre_p), q = m.get(m.batch->centre_q);
  const V w1 = dot(motion.w, m.t1), w2 = dot(motion.w, m.t2), wn = dot(motion.w, m.n);
  return {dot(motion.u, m.t1) + (w2 * offset - wn * q), dot(motion.u, m.t2) + (wn * p - w1 * offset), wn};
}

// The friction impulse that stops the slip, cut to what the normal impulses allow; returns the change as a wrench.
// Lanes outside `rubs` keep theirs.
template <class V, template <class> class B, class Mask>
Wrench<V> solve_friction(const Manifolds<V, B>& m, const Motion<V>& motion, const Pressure<V>& pressure, Mask rubs) {
  ContactBatch& batch = *m.batch;
  const V p = m.get(batch.centre_p), q = m.get(batch.centre_q);
  FrictionMatrix<V> inverse;
  for (int k = 0; k < 6; ++k) inverse.of[k] = m.get(batch.friction_inverse[k]);
  const Friction<V> missing = inverse.times(slip_of(m, motion));
  const V before1 = m.get(batch.force1), before2 = m.get(batch.force2), twist_before = m.get(batch.twist);
  const Friction<V> wanted = {before1 - missing.force1, before2 - missing.force2, twist_before - missing.twist};
  Friction<V> now = within_limits(m, pressure, wanted, inverse, rubs);
  now = {rubs ? now.force1 : before1, rubs ? now.force2 : before2, rubs ? now.twist : twist_before};
  const V d1 = now.force1 - before1, d2 = now.force2 - before2;
  m.set(batch.force1, now.force1);
  m.set(batch.force2, now.force2);
  m.set(batch.twist, now.twist);
  return friction_wrench(m, d1, d2, (now.twist - twist_before) + (p * d2 - q * d1));
}

}  // namespace
}  // namespace tumble::sim
