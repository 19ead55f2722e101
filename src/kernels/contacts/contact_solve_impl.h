#pragma once

// Sweeps and the motion of separations, for any number of lanes. lane_vector.h says who may include this.

#include "src/kernels/contacts/contact_friction_impl.h"
#include "src/kernels/contacts/contact_impacts_impl.h"
#include "src/kernels/contacts/contact_lanes.h"
#include "src/kernels/contacts/contact_levers_impl.h"

namespace tumble::sim {
namespace {

constexpr int kInner = 2;              // Jacobi passes over a manifold's points in one visit
constexpr int kInnerRestitution = 12;  // in the first turn of a bounce
constexpr double kPushMax = 1;         // m/s
constexpr double kGivenWay = 0.1;      // of the normals' sum; where less is lost, the next visit cuts friction

template <class V, template <class> class B>
Pressure<V> pressure_of(const Manifolds<V, B>& m) {
  const V magic = m.get(m.batch->impulse_magic);
  Pressure<V> pressure = {V{}, V{}};
  for (unsigned k = 0; k < m.batch->count; ++k) {
    const V impulse = m.get(m.points[k].impulse);
    pressure.sum += to_grid(magic, impulse);
    pressure.most = larger(pressure.most, impulse);
  }
  if (any_above(pressure.sum, m.get(m.batch->impulse_max))) [[unlikely]]
    pressure.sum = add_up_impulses(m).s;
  return pressure;
}

// The normal velocity that a point should have, negated: added to the velocity that the impulse drives to zero. Between
// kSkin apart and the slop of overlap a point is held as it is. If separations were closed down to zero, a resting box
// would rock: corners a nanometre apart carry nothing for a substep, and tall stacks sway apart.
template <Sweep kSweep, class V>
V bias_of(const ContactWork& work, V separation, V slop) {
  const double h = work.substep_s;
  const V zero = V{};
  V held = zero;
  if constexpr (kSweep != Sweep::kHold) {
    held = larger(V{} - kPushMax, (work.push_part / h) * smaller(zero, separation + slop));
  }
  if (!any_above(separation, zero + kSkin)) return held;  // a division takes as long as the rest of a point
  return separation > kSkin ? separation / h : held;
}

// The speed after a bounce: e times the speed of impact, less the speed that gravity has taken since the impact.
template <class V, template <class> class B>
V rebound(const Manifolds<V, B>& m, V approach, V separation) {
  const V speed = m.get(m.batch->restitution) * approach, zero = V{};
  return square_root(larger(zero, speed * speed + 2.0 * m.get(m.batch->acceleration) * separation));
}

// The velocity that a point should have, negated; constant during the passes over the points.
template <Sweep kSweep, class V, template <class> class B>
V unwanted_speed(const ContactWork& work, const Manifolds<V, B>& m, const PointBatch& point) {
  const V separation = m.get(point.separation);
  if constexpr (kSweep == Sweep::kRestitution) return -rebound(m, m.get(point.approach), separation);
  return bias_of<kSweep>(work, separation, m.get(m.batch->slop));
}

template <Sweep kSweep, class V, template <class> class B>
V wanted_impulse(const Manifolds<V, B>& m, const PointBatch& point, V speed) {
  const V impulse = m.get(point.impulse);
  const V wanted = impulse - m.get(m.batch->relaxation) * (m.get(point.mass) * speed);
  if constexpr (kSweep == Sweep::kRestitution) {
    const V met = m.get(point.approach) > -bounce_min(*m.batch) ? impulse : wanted;
    return m.get(point.peak) == 0.0 ? impulse : met;
  }
  return wanted;
}

template <Sweep kSweep, class V, template <class> class B>
Wrench<V> solve_normals(const ContactWork& work, const Manifolds<V, B>& m, const Motion<V>& motion, V pressure,
                        [[maybe_unused]] int passes = kInner) {
  V u = dot(motion.u, m.n), w1 = dot(motion.w, m.t1), w2 = dot(motion.w, m.t2);
  const V magic = m.get(m.batch->impulse_magic), impulse_max = m.get(m.batch->impulse_max), zero = V{};
  V r[6];
  for (int k = 0; k < 6; ++k) r[k] = m.get(m.batch->response[k]);
  V unwanted[kPointsMax], changes[kPointsMax], before[kSweep == Sweep::kRestitution ? kPointsMax : 1];
  PointSums<V> begun = {};  // of the impulses before
  if constexpr (kSweep == Sweep::kRestitution) {
    for (unsigned k = 0; k < m.batch->count; ++k) before[k] = m.get(m.points[k].impulse);
    begun = sums_of_impulses(m);
  }
  if (kSweep == Sweep::kPart && !m.batch->hard) {
    for (unsigned k = 0; k < m.batch->count; ++k) unwanted[k] = m.get(m.points[k].load);  // begin_parting
  } else {
    for (unsigned k = 0; k < m.batch->count; ++k) unwanted[k] = unwanted_speed<kSweep>(work, m, m.points[k]);
  }
  V total_s = zero, total_sq = zero, total_sp = zero;
  const int last = kSweep == Sweep::kRestitution ? passes : kInner;  // a constant where it can be
  for (int pass = 0; pass < last; ++pass) {
    PointSums<V> sums = {};
    for (unsigned k = 0; k < m.batch->count; ++k) {
      PointBatch& point = m.points[k];
      const V p = m.get(point.p), q = m.get(point.q);
      const V speed = (u + (w1 * q - w2 * p)) + unwanted[k];
      const V impulse = larger(zero, wanted_impulse<kSweep>(m, point, speed));
      const V change = changes[k] = impulse - m.get(point.impulse);
      m.set(point.impulse, impulse);
      if constexpr (kSweep != Sweep::kPart) m.set(point.peak, larger(m.get(point.peak), impulse));
      sums.s += to_grid(magic, change);
      sums.sq += to_grid(magic, change * q);
      sums.sp += to_grid(magic, change * p);
    }
    // No impulse is negative, so no change is larger than the sums before and after.
    if (any_above(pressure + (pressure + sums.s), impulse_max)) [[unlikely]]
      sums = add_up(m, changes);
    pressure += sums.s;
    total_s += sums.s;
    total_sq += sums.sq;
    total_sp += sums.sp;
    u += r[0] * sums.s + (r[1] * sums.sq + r[2] * sums.sp);
    w1 += r[1] * sums.s + (r[3] * sums.sq + r[4] * sums.sp);
    w2 += -r[2] * sums.s + (-r[4] * sums.sq + r[5] * sums.sp);
  }
  if constexpr (kSweep == Sweep::kRestitution) {
    const PointSums<V> given = {total_s, total_sq, total_sp};
    const V part = part_of_bounce(work, m, motion, {u, w1, w2}, begun, given);
    for (unsigned k = 0; k < m.batch->count; ++k) {
      m.set(m.points[k].impulse, before[k] + part * (m.get(m.points[k].impulse) - before[k]));
    }
    return normal_wrench(m, part * total_s, part * total_sq, part * total_sp);
  }
  return normal_wrench(m, total_s, total_sq, total_sp);
}

// The motion of b relative to a after an impulse, with the split masses.
template <class V, template <class> class B>
Motion<V> after(const Manifolds<V, B>& m, const Motion<V>& motion, const Wrench<V>& wrench) {
  const V split_a = m.get(m.batch->split_a), split_b = m.get(m.batch->split_b);
  const Space<V> va = velocity_of(m.a, wrench.force) * -split_a, vb = velocity_of(m.b, wrench.force) * split_b;
  const Space<V> wa = spin_of(m.a, reaction_torque(m, wrench)) * -split_a;
  const Space<V> wb = spin_of(m.b, wrench.torque) * split_b;
  return {motion.u + ((vb - va) - cross(wa, m.d)), motion.w + (wb - wa)};
}

template <class V>
Wrench<V> operator+(const Wrench<V>& a, const Wrench<V>& b) {
  return {a.force + b.force, a.torque + b.torque};
}

// The lanes of which a point met fast enough to bounce.
template <class V, template <class> class B>
auto met_fast(const Manifolds<V, B>& m) {
  const V least = V{} - bounce_min(*m.batch);
  V fastest = V{};
  for (unsigned k = 0; k < m.batch->count; ++k) {
    const PointBatch& point = m.points[k];
    fastest = smaller(fastest, m.get(point.peak) == 0.0 ? V{} : m.get(point.approach));
  }
  return fastest <= least;
}

// A bounce: its push presses the faces together once more, so friction takes its part of that too. From the second turn
// on friction has had its part of all but the push of the turn before, as in a visit that holds. Lanes that do not
// bounce do the same work, for what a lane does must not depend on the others.
template <class V, template <class> class B>
Wrench<V> bounce(const ContactWork& work, const Manifolds<V, B>& m, const Motion<V>& motion, V pressure) {
  const bool again = work.visit.bounces && work.visit.sweep > 0;
  const int passes = again ? kInner : kInnerRestitution;
  Wrench<V> push = {};
  Motion<V> pushed = motion;
  if (!again) {
    push = solve_normals<Sweep::kRestitution>(work, m, motion, pressure, passes);
    pushed = after(m, motion, push);
  }
  const Pressure<V> now = pressure_of(m);
  const Wrench<V> friction = solve_friction(m, pushed, now, met_fast(m));
  const Motion<V> rubbed = after(m, pushed, friction);
  return (push + friction) + solve_normals<Sweep::kRestitution>(work, m, rubbed, now.sum, passes);
}

// Where the normals have given way, friction that they bore is more than its cone allows now: a body that lands would
// be kicked along the ground as the push of its landing ends.
template <class V, template <class> class B, class Mask>
[[gnu::noinline]] Wrench<V> let_go(const Manifolds<V, B>& m, const Motion<V>& motion, Mask gave_way) {
  const ContactBatch& batch = *m.batch;
  const Pressure<V> now = pressure_of(m);
  const V coefficient = m.get(batch.sliding) == 1.0 ? m.get(batch.friction_dynamic) : m.get(batch.friction);
  const V most = (coefficient * now.sum) / (1 - kGivenWay), force1 = m.get(batch.force1), force2 = m.get(batch.force2);
  const auto too_much = gave_way & (force1 * force1 + force2 * force2 > most * most);
  return any(too_much) ? solve_friction(m, motion, now, too_much) : Wrench<V>{};
}

template <Sweep kSweep, class V, template <class> class B = Body>
void solve_manifolds(const ContactWork& work, ContactBatch& batch, unsigned at) {
  const Manifolds<V, B> m(work, batch, at);
  const Motion<V> motion = relative_motion(m);
  const Pressure<V> pressure = pressure_of(m);
  if constexpr (kSweep == Sweep::kPart) {
    write_outcomes(work, m, solve_normals<kSweep>(work, m, motion, pressure.sum));
  } else if constexpr (kSweep == Sweep::kRestitution) {
    write_outcomes(work, m, bounce(work, m, motion, pressure.sum));
  } else {
    const Wrench<V> friction = solve_friction(m, motion, pressure, V{} == V{});
    Wrench<V> all = friction + solve_normals<kSweep>(work, m, after(m, motion, friction), pressure.sum);
    const auto gave_way = dot(all.force, m.n) < -kGivenWay * pressure.sum;
    if (any(gave_way)) all = all + let_go(m, after(m, motion, all), gave_way);
    write_outcomes(work, m, all);
  }
}

template <class V, template <class> class B>
void solve_sweep(const ContactWork& work, ContactBatch& batch, unsigned at, Sweep sweep) {
  if (sweep == Sweep::kPush) return solve_manifolds<Sweep::kPush, V, B>(work, batch, at);
  if (sweep == Sweep::kHold) return solve_manifolds<Sweep::kHold, V, B>(work, batch, at);
  solve_manifolds<Sweep::kPart, V, B>(work, batch, at);
}

// Apart, so that the usual sweeps stay small.
template <class V>
[[gnu::flatten, gnu::noinline]] void solve_bounces(const ContactWork& work, ContactBatch& batch, unsigned at) {
  solve_manifolds<Sweep::kRestitution, V>(work, batch, at);
}

template <class V>
void solve(const ContactWork& work, ContactBatch& batch, unsigned at, Sweep sweep) {
  if (sweep == Sweep::kRestitution) return solve_bounces<V>(work, batch, at);
  return batch.even ? solve_sweep<V, EvenBody>(work, batch, at, sweep) : solve_sweep<V, Body>(work, batch, at, sweep);
}

// The speeds that kPart wants stay as they are from sweep to sweep. Hard batches are hashed with all their columns.
template <class V>
void begin_parting(const ContactWork& work, const ContactBatch& batch) {
  for (unsigned at = 0; at < kLanes; at += sizeof(V) / sizeof(double)) {
    const V slop = load<V>(batch.slop.of + at);
    for (unsigned k = batch.first; k < batch.first + batch.count; ++k) {
      PointBatch& point = work.points[k];
      if (!batch.hard) {
        store(point.load.of + at, bias_of<Sweep::kPart>(work, load<V>(point.separation.of + at), slop));
      }
      store(point.peak.of + at, load<V>(point.impulse.of + at));
      store(point.impulse.of + at, V{} + 0.0);
    }
  }
}

template <class V>
void move_on(const ContactWork& work, ContactBatch& batch, unsigned at) {
  const Manifolds<V, EvenBody> m(work, batch, at);  // of any body, velocity and spin
  const Motion<V> motion = relative_motion(m);
  const V u = dot(motion.u, m.n), w1 = dot(motion.w, m.t1), w2 = dot(motion.w, m.t2);
  for (unsigned k = 0; k < batch.count; ++k) {
    PointBatch& point = m.points[k];
    const V speed = u + (w1 * m.get(point.q) - w2 * m.get(point.p));
    m.set(point.separation, m.get(point.separation) + work.substep_s * speed);
  }
  if (at == 0) batch.levers_turned = false;
  if (work.turn_s > 0) turn_levers(m, work.turn_s);
}

}  // namespace
}  // namespace tumble::sim
