#pragma once

// The mathematics of contacts, written once for any number of lanes; see lane_vector.h for who may include this.
//
// A manifold's points lie in a plane, so what the normal impulses λ of its points do to the bodies depends only on
// three sums, S = Σλ, Sq = Σλq, Sp = Σλp, and what the bodies do to the points only on three numbers: the normal
// velocity u at b's centre and the parts W1, W2 of the relative spin, v(p, q) = u + W1 q − W2 p.

#include "src/solve/contact_kernels.h"
#include "src/solve/lane_rows.h"
#include "src/solve/lane_vector.h"

namespace tumble::sim {
namespace {

constexpr int kInner = 2;              // Jacobi passes over a manifold's points in one visit
constexpr int kInnerRestitution = 12;  // visited once a step, and what it misses is energy lost
constexpr double kPushPart = 0.05;     // of an overlap removed in a sub-step
constexpr double kSkin = 0.0001;       // m of air that counts as touching; see bias_of
constexpr double kSlop = 0.0005;       // m of overlap that is left alone
constexpr double kPushMax = 1;         // m/s
constexpr double kMotionMagic = 6755399441055744.0 / 274877906944.0;  // VelocityGrid's

template <class V>
V round_motion(V x) {
  return ((x + kMotionMagic) - kMotionMagic) + 0.0;
}

template <class V>
struct Body {
  Space<V> velocity, spin;
  V inverse_mass;
  V inertia[6];  // inverse, world axes: xx, xy, xz, yy, yz, zz
};

template <class V>
Body<V> gather_body(const double* bodies, const std::uint32_t* row) {
  V c[16];
  for (unsigned at = 0; at < 16; at += 4) gather4(bodies, kSolverBodyDoubles, row, at, c + at);
  return {{c[0], c[1], c[2]}, {c[3], c[4], c[5]}, c[6], {c[8], c[9], c[10], c[11], c[12], c[13]}};
}

// I⁻¹ torque.
template <class V>
Space<V> spin_of(const Body<V>& body, Space<V> t) {
  const V* i = body.inertia;
  return {(i[0] * t.x + i[1] * t.y) + i[2] * t.z, (i[1] * t.x + i[3] * t.y) + i[4] * t.z,
          (i[2] * t.x + i[4] * t.y) + i[5] * t.z};
}

// As many manifolds of a batch as the width takes, from lane `at` on.
template <class V>
struct Manifolds {
  ContactBatch* batch;
  PointBatch* points;
  unsigned at;
  Space<V> n, t1, t2, d;
  Body<V> a, b;

  Manifolds(const ContactWork& work, ContactBatch& of, unsigned lane)
      : batch(&of),
        points(work.points + of.first),
        at(lane),
        n(space(of.n)),
        t1(space(of.t1)),
        t2(space(of.t2)),
        d(space(of.d)),
        a(gather_body<V>(work.bodies, of.a + lane)),
        b(gather_body<V>(work.bodies, of.b + lane)) {}

  V get(const Lanes& lanes) const { return load<V>(lanes.of + at); }
  void set(Lanes& lanes, V v) const { store(lanes.of + at, v); }
  Space<V> space(const Lanes* lanes) const { return {get(lanes[0]), get(lanes[1]), get(lanes[2])}; }
};

// Motion of b against a. u: of b's centre in a's (moving) frame; w: relative spin.
template <class V>
struct Motion {
  Space<V> u, w;
};
template <class V>
Motion<V> relative_motion(const Manifolds<V>& m) {
  return {(m.b.velocity - m.a.velocity) - cross(m.a.spin, m.d), m.b.spin - m.a.spin};
}

// An impulse on b: a force through b's centre and a torque. a receives the opposite at the same place.
template <class V>
struct Wrench {
  Space<V> force, torque;
};
template <class V>
Space<V> reaction_torque(const Manifolds<V>& m, const Wrench<V>& wrench) {
  return wrench.torque + cross(m.d, wrench.force);
}
template <class V>
Wrench<V> normal_wrench(const Manifolds<V>& m, V s, V sq, V sp) {
  return {m.n * s, m.t1 * sq - m.t2 * sp};
}
template <class V>
Wrench<V> friction_wrench(const Manifolds<V>& m, V force1, V force2, V turn) {
  const V offset = m.get(m.batch->offset);
  return {m.t1 * force1 + m.t2 * force2, (m.t1 * (-offset * force2) + m.t2 * (offset * force1)) + m.n * turn};
}

template <class V>
void add_side(double* sums, const std::uint32_t* row, const Body<V>& body, Space<V> force, Space<V> torque) {
  const Space<V> v = force * body.inverse_mass, w = spin_of(body, torque);
  const V zero = V{} + 0.0;
  const V first[4] = {round_motion(v.x), round_motion(v.y), round_motion(v.z), round_motion(w.x)};
  const V second[4] = {round_motion(w.y), round_motion(w.z), zero, zero};
  add4(sums, kSolverMotionDoubles, row, 0, first);
  add4(sums, kSolverMotionDoubles, row, 4, second);
}

template <class V>
void add_wrench(double* sums, const Manifolds<V>& m, const Wrench<V>& wrench) {
  add_side(sums, m.batch->b + m.at, m.b, wrench.force, wrench.torque);
  add_side(sums, m.batch->a + m.at, m.a, -wrench.force, -reaction_torque(m, wrench));
}

// Impulses are rounded to a power-of-two grid that is fine for the lighter body, so that their sums have no order.
template <class V>
V round_impulse(V magic, V x) {
  return (x + magic) - magic;
}

// The friction impulse that stops the slip, cut to what the normal impulses allow; returns the change as a wrench.
template <class V>
Wrench<V> solve_friction(const Manifolds<V>& m, const Motion<V>& motion) {
  ContactBatch& batch = *m.batch;
  const V offset = m.get(batch.offset), p = m.get(batch.centre_p), q = m.get(batch.centre_q);
  const V magic = m.get(batch.impulse_magic);
  const V w1 = dot(motion.w, m.t1), w2 = dot(motion.w, m.t2), wn = dot(motion.w, m.n);
  const V u1 = dot(motion.u, m.t1) + (w2 * offset - wn * q);
  const V u2 = dot(motion.u, m.t2) + (wn * p - w1 * offset);
  V pressure = V{};
  for (unsigned k = 0; k < batch.count; ++k) pressure += round_impulse(magic, m.get(m.points[k].impulse));
  V f[6];
  for (int k = 0; k < 6; ++k) f[k] = m.get(batch.friction_inverse[k]);
  const V before1 = m.get(batch.force1), before2 = m.get(batch.force2), twist_before = m.get(batch.twist);
  const V stop1 = before1 - ((f[0] * u1 + f[1] * u2) + f[2] * wn);
  const V stop2 = before2 - ((f[1] * u1 + f[3] * u2) + f[4] * wn);
  const V limit = m.get(batch.friction) * pressure, squared = stop1 * stop1 + stop2 * stop2;
  const V scale = m.get(batch.friction_dynamic) * pressure / square_root(squared);
  const auto slips = squared > limit * limit;
  const V force1 = slips ? stop1 * scale : stop1, force2 = slips ? stop2 * scale : stop2;
  const V twist_limit = limit * m.get(batch.radius);
  const V twist_stop = twist_before - ((f[2] * u1 + f[4] * u2) + f[5] * wn);
  const V twist = twist_stop < -twist_limit ? -twist_limit : (twist_limit < twist_stop ? twist_limit : twist_stop);
  const V d1 = force1 - before1, d2 = force2 - before2;
  m.set(batch.force1, force1);
  m.set(batch.force2, force2);
  m.set(batch.twist, twist);
  return friction_wrench(m, d1, d2, (twist - twist_before) + (p * d2 - q * d1));
}

// The normal velocity a point should have, negated: what is added to its velocity before it is driven to zero. Between
// skin and slop a point is simply held. Were the gap closed down to zero, a resting box would rock: corners that are a
// nanometre apart carry nothing for a sub-step, and tall stacks sway themselves apart on it.
template <Sweep kSweep, class V>
V bias_of(V separation, double h) {
  const V gap = separation / h, zero = V{};
  if constexpr (kSweep == Sweep::kRelax) return separation > kSkin ? gap : zero;
  const V push = larger(V{} - kPushMax, (kPushPart / h) * smaller(zero, separation + kSlop));
  return separation > kSkin ? gap : push;
}

// e times the speed of impact, less what the way from the contact to here has cost since.
template <class V>
V rebound(const Manifolds<V>& m, V approach, V separation) {
  const V speed = m.get(m.batch->restitution) * approach, zero = V{};
  return square_root(larger(zero, speed * speed + 2.0 * m.get(m.batch->acceleration) * separation));
}

template <Sweep kSweep, class V>
V wanted_impulse(const Manifolds<V>& m, const PointBatch& point, V speed, double h) {
  const V impulse = m.get(point.impulse), separation = m.get(point.separation);
  const V relaxation = m.get(m.batch->relaxation), mass = m.get(point.mass);
  if constexpr (kSweep == Sweep::kRestitution) {
    const V approach = m.get(point.approach);
    const V bounced = impulse - relaxation * (mass * (speed - rebound(m, approach, separation)));
    const V met = approach > -kBounceMin ? impulse : bounced;
    return m.get(point.peak) == 0.0 ? impulse : met;
  } else {
    return impulse - relaxation * (mass * (speed + bias_of<kSweep>(separation, h)));
  }
}

template <Sweep kSweep, class V>
Wrench<V> solve_normals(const Manifolds<V>& m, const Motion<V>& motion, double h) {
  V u = dot(motion.u, m.n), w1 = dot(motion.w, m.t1), w2 = dot(motion.w, m.t2);
  const V magic = m.get(m.batch->impulse_magic), zero = V{};
  V r[6];
  for (int k = 0; k < 6; ++k) r[k] = m.get(m.batch->response[k]);
  V total_s = zero, total_sq = zero, total_sp = zero;
  constexpr int kPasses = kSweep == Sweep::kRestitution ? kInnerRestitution : kInner;
  for (int pass = 0; pass < kPasses; ++pass) {
    V s = zero, sq = zero, sp = zero;
    for (unsigned k = 0; k < m.batch->count; ++k) {
      PointBatch& point = m.points[k];
      const V p = m.get(point.p), q = m.get(point.q);
      const V speed = u + (w1 * q - w2 * p);
      const V impulse = larger(zero, wanted_impulse<kSweep>(m, point, speed, h));
      const V change = impulse - m.get(point.impulse);
      m.set(point.impulse, impulse);
      m.set(point.peak, larger(m.get(point.peak), impulse));
      s += round_impulse(magic, change);
      sq += round_impulse(magic, change * q);
      sp += round_impulse(magic, change * p);
    }
    total_s += s;
    total_sq += sq;
    total_sp += sp;
    u += r[0] * s + (r[1] * sq + r[2] * sp);
    w1 += r[1] * s + (r[3] * sq + r[4] * sp);
    w2 += -r[2] * s + (-r[4] * sq + r[5] * sp);
  }
  return normal_wrench(m, total_s, total_sq, total_sp);
}

template <Sweep kSweep, class V>
void solve_manifolds(const ContactWork& work, ContactBatch& batch, unsigned at) {
  const Manifolds<V> m(work, batch, at);
  Motion<V> motion = relative_motion(m);
  if constexpr (kSweep == Sweep::kRestitution) {
    add_wrench(work.sums, m, solve_normals<kSweep>(m, motion, work.substep_s));
  } else {
    const Wrench<V> friction = solve_friction(m, motion);
    const V split_a = m.get(batch.split_a), split_b = m.get(batch.split_b);
    const Space<V> va = friction.force * (-m.a.inverse_mass * split_a);
    const Space<V> vb = friction.force * (m.b.inverse_mass * split_b);
    const Space<V> wa = spin_of(m.a, reaction_torque(m, friction)) * -split_a;
    const Space<V> wb = spin_of(m.b, friction.torque) * split_b;
    motion.u = motion.u + ((vb - va) - cross(wa, m.d));
    motion.w = motion.w + (wb - wa);
    const Wrench<V> normal = solve_normals<kSweep>(m, motion, work.substep_s);
    add_wrench(work.sums, m, {friction.force + normal.force, friction.torque + normal.torque});
  }
}

template <class V>
void solve(const ContactWork& work, ContactBatch& batch, unsigned at, Sweep sweep) {
  if (sweep == Sweep::kPush) return solve_manifolds<Sweep::kPush, V>(work, batch, at);
  if (sweep == Sweep::kRelax) return solve_manifolds<Sweep::kRelax, V>(work, batch, at);
  if (batch.bounces) solve_manifolds<Sweep::kRestitution, V>(work, batch, at);
}

template <class V>
void warm_start(const ContactWork& work, ContactBatch& batch, unsigned at) {
  const Manifolds<V> m(work, batch, at);
  const V magic = m.get(batch.impulse_magic);
  V s = V{}, sq = V{}, sp = V{};
  for (unsigned k = 0; k < batch.count; ++k) {
    const PointBatch& point = m.points[k];
    const V impulse = m.get(point.impulse);
    s += round_impulse(magic, impulse);
    sq += round_impulse(magic, impulse * m.get(point.q));
    sp += round_impulse(magic, impulse * m.get(point.p));
  }
  const V force1 = m.get(batch.force1), force2 = m.get(batch.force2);
  const V turn = m.get(batch.twist) + (m.get(batch.centre_p) * force2 - m.get(batch.centre_q) * force1);
  const Wrench<V> normal = normal_wrench(m, s, sq, sp), friction = friction_wrench(m, force1, force2, turn);
  add_wrench(work.sums, m, {normal.force + friction.force, normal.torque + friction.torque});
}

template <class V>
void move_on(const ContactWork& work, ContactBatch& batch, unsigned at) {
  const Manifolds<V> m(work, batch, at);
  const Motion<V> motion = relative_motion(m);
  const V u = dot(motion.u, m.n), w1 = dot(motion.w, m.t1), w2 = dot(motion.w, m.t2);
  for (unsigned k = 0; k < batch.count; ++k) {
    PointBatch& point = m.points[k];
    const V speed = u + (w1 * m.get(point.q) - w2 * m.get(point.p));
    m.set(point.separation, m.get(point.separation) + work.substep_s * speed);
  }
}

// Calls visit.template operator()<V>(batch, at) for kWidth lanes at a time; the last ones of a batch go to the
// narrowest vector that holds them, since one manifold in eight lanes takes longer than on its own.
template <int kWidth, class Visit>
void for_packs(const ContactWork& work, Visit visit) {
  for (std::size_t k = 0; k < work.count; ++k) {
    ContactBatch& batch = work.batches[k];
    for (unsigned at = 0; at < batch.used; at += kWidth) {
      const unsigned left = batch.used - at;
      if (kWidth == 1 || left == 1) {
        visit(VectorOf<1>::Type{}, batch, at);
      } else if (kWidth == 2 || left == 2) {
        visit(typename VectorOf < kWidth < 2 ? 1 : 2 > ::Type{}, batch, at);
      } else if (kWidth == 4 || left <= 4) {
        visit(typename VectorOf < kWidth < 4 ? 1 : 4 > ::Type{}, batch, at);
      } else {
        visit(typename VectorOf<kWidth>::Type{}, batch, at);
      }
    }
  }
}

template <int kWidth>
void solve_all(const ContactWork& work, Sweep sweep) {
  for_packs<kWidth>(work,
                    [&](auto v, ContactBatch& batch, unsigned at) { solve<decltype(v)>(work, batch, at, sweep); });
}
template <int kWidth>
void warm_start_all(const ContactWork& work) {
  for_packs<kWidth>(work, [&](auto v, ContactBatch& batch, unsigned at) { warm_start<decltype(v)>(work, batch, at); });
}
template <int kWidth>
void move_on_all(const ContactWork& work) {
  for_packs<kWidth>(work, [&](auto v, ContactBatch& batch, unsigned at) { move_on<decltype(v)>(work, batch, at); });
}

template <int kWidth>
constexpr ContactKernels kernels_of(LaneWidth width) {
  return {width, solve_all<kWidth>, warm_start_all<kWidth>, move_on_all<kWidth>};
}

}  // namespace
}  // namespace tumble::sim
