#pragma once

// Manifolds in lanes, and the effect of a wrench on the bodies. lane_vector.h says who may include this.
//
// The points of a manifold lie in a plane. So the effect of their normal impulses λ on the bodies depends on three sums
// alone, S = Σλ, Sq = Σλq, Sp = Σλp; and the velocities of the points depend on three numbers alone, the normal
// velocity u at b's centre and the parts W1, W2 of the relative spin: v(p, q) = u + W1 q − W2 p.

#include "src/kernels/contacts/contact_kernels.h"
#include "src/kernels/lanes/lane_rows.h"
#include "src/kernels/lanes/lane_vector.h"
#include "src/math/grid_magic.h"

namespace tumble::sim {
namespace {

template <class V>
struct Body {
  Space<V> velocity, spin;
  V inverse_mass;
  V inertia[6];  // inverse, world axes: xx, xy, xz, yy, yz, zz
  Space<V> lent;

  Body(const double* bodies, const std::uint32_t* row) {
    V c[16];
    for (unsigned at = 0; at < 16; at += 4) gather4(bodies, kSolverBodyDoubles, row, at, c + at);
    velocity = {c[0], c[1], c[2]};
    spin = {c[3], c[4], c[5]};
    inverse_mass = c[6];
    for (int k = 0; k < 6; ++k) inertia[k] = c[7 + k];
    lent = {c[13], c[14], c[15]};
  }
};

// A body of an even batch: eight of its numbers say all, and the zeros of the others need no arithmetic. Results are
// those of Body up to the signs of zeros, which no sum on a grid keeps.
template <class V>
struct EvenBody {
  Space<V> velocity, spin;
  V inverse_mass, inertia;

  EvenBody(const double* bodies, const std::uint32_t* row) {
    V c[8];
    for (unsigned at = 0; at < 8; at += 4) gather4(bodies, kSolverBodyDoubles, row, at, c + at);
    velocity = {c[0], c[1], c[2]};
    spin = {c[3], c[4], c[5]};
    inverse_mass = c[6];
    inertia = c[7];
  }
};

// The lanes in which a Body is even.
template <class V>
auto is_even(const Body<V>& body) {
  const V* i = body.inertia;
  const auto alike = (i[0] == i[3]) & (i[0] == i[5]) & (i[1] == 0.0) & (i[2] == 0.0) & (i[4] == 0.0);
  return alike & (body.lent.x == 0.0) & (body.lent.y == 0.0) & (body.lent.z == 0.0);
}

// The change of velocity by a force: M⁻¹ force.
template <class V>
Space<V> velocity_of(const Body<V>& body, Space<V> force) {
  return force * body.inverse_mass - body.lent * dot(body.lent, force);
}
template <class V>
Space<V> velocity_of(const EvenBody<V>& body, Space<V> force) {
  return force * body.inverse_mass;
}

// I⁻¹ torque.
template <class V>
Space<V> spin_of(const Body<V>& body, Space<V> t) {
  const V* i = body.inertia;
  return {(i[0] * t.x + i[1] * t.y) + i[2] * t.z, (i[1] * t.x + i[3] * t.y) + i[4] * t.z,
          (i[2] * t.x + i[4] * t.y) + i[5] * t.z};
}
template <class V>
Space<V> spin_of(const EvenBody<V>& body, Space<V> t) {
  return t * body.inertia;
}

// Manifolds of a batch, as many as V has lanes, from lane `at` on. B: Body, or EvenBody for an even batch.
template <class V, template <class> class B = Body>
struct Manifolds {
  ContactBatch* batch;
  PointBatch* points;
  unsigned at;
  Space<V> n, t1, t2, d;
  B<V> a, b;

  Manifolds(const ContactWork& work, ContactBatch& of, unsigned lane)
      : Manifolds(work, of, work.sides[&of - work.batches], lane) {}
  Manifolds(const ContactWork& work, ContactBatch& of, const BatchSides& sides, unsigned lane)
      : batch(&of),
        points(work.points + of.first),
        at(lane),
        n(space(of.n)),
        t1(space(of.t1)),
        t2(space(of.t2)),
        d(space(of.d)),
        a(work.bodies, sides.a + lane),
        b(work.bodies, sides.b + lane) {}

  V get(const Lanes& lanes) const { return load<V>(lanes.of + at); }
  void set(Lanes& lanes, V v) const { store(lanes.of + at, v); }
  Space<V> space(const Lanes* lanes) const { return {get(lanes[0]), get(lanes[1]), get(lanes[2])}; }
};

// Motion of b relative to a. u: velocity of b's centre in a's (moving) frame; w: relative spin.
template <class V>
struct Motion {
  Space<V> u, w;
};
template <class V, template <class> class B>
Motion<V> relative_motion(const Manifolds<V, B>& m) {
  return {(m.b.velocity - m.a.velocity) - cross(m.a.spin, m.d), m.b.spin - m.a.spin};
}

// An impulse on b: a force through b's centre and a torque. Body a receives the opposite at the same place.
template <class V>
struct Wrench {
  Space<V> force, torque;
};
template <class V, template <class> class B>
Space<V> reaction_torque(const Manifolds<V, B>& m, const Wrench<V>& wrench) {
  return wrench.torque + cross(m.d, wrench.force);
}
template <class V, template <class> class B>
Wrench<V> normal_wrench(const Manifolds<V, B>& m, V s, V sq, V sp) {
  return {m.n * s, m.t1 * sq - m.t2 * sp};
}
template <class V, template <class> class B>
Wrench<V> friction_wrench(const Manifolds<V, B>& m, V force1, V force2, V turn) {
  const V offset = m.get(m.batch->offset);
  return {m.t1 * force1 + m.t2 * force2, (m.t1 * (-offset * force2) + m.t2 * (offset * force1)) + m.n * turn};
}

template <class V, template <class> class B>
void write_side(double* outcomes, const B<V>& body, Space<V> force, Space<V> torque) {
  const Space<V> v = velocity_of(body, force), w = spin_of(body, torque);
  const V zero = V{} + 0.0;
  const V first[4] = {v.x, v.y, v.z, w.x}, second[4] = {w.y, w.z, zero, zero};
  scatter4(outcomes, 2 * kOutcomeDoubles, first);
  scatter4(outcomes + 4, 2 * kOutcomeDoubles, second);
}

template <class V, template <class> class B>
void write_outcomes(const ContactWork& work, const Manifolds<V, B>& m, const Wrench<V>& wrench) {
  const std::size_t lane = static_cast<std::size_t>(m.batch - work.batches) * kLanes + m.at;
  double* const row = work.outcomes + 2 * lane * kOutcomeDoubles;
  write_side(row, m.a, -wrench.force, -reaction_torque(m, wrench));
  write_side(row + kOutcomeDoubles, m.b, wrench.force, wrench.torque);
}

// Rounds to the grid of `magic`: sums of impulses are then exact, and no order of points shows (math/grid.h).
template <class V>
V to_grid(V magic, V x) {
  return (x + magic) - magic;
}

// fitting_magic of math/grid.h in each lane. The usual grid of impulses fits the lighter body, and a body ten thousand
// times as heavy can meet the lighter one with more than that grid holds.
template <class V>
V fitting_magic(V usual, V magnitudes) {
  return magnitudes <= usual ? usual : 3.0 * power_of_two(magnitudes);
}

// The sums over the points of an impulse and of its moments.
template <class V>
struct PointSums {
  V s, sq, sp;
};

// The number of points, at least 4: fitting_magic wants no term larger than a quarter of all.
template <class V, template <class> class B>
V terms_of(const Manifolds<V, B>& m) {
  return larger(V{} + 4.0, m.get(m.batch->point_count));
}

// The sums of `impulses`, one a point, of any size: the largest term chooses each grid.
template <class V, template <class> class B>
PointSums<V> add_up(const Manifolds<V, B>& m, const V* impulses) {
  const unsigned count = m.batch->count;
  PointSums<V> largest = {};
  for (unsigned k = 0; k < count; ++k) {
    const V x = impulses[k];
    largest.s = larger(largest.s, magnitude(x));
    largest.sq = larger(largest.sq, magnitude(x * m.get(m.points[k].q)));
    largest.sp = larger(largest.sp, magnitude(x * m.get(m.points[k].p)));
  }
  const V usual = m.get(m.batch->impulse_magic), terms = terms_of(m);
  const V magic_s = fitting_magic(usual, largest.s * terms), magic_q = fitting_magic(usual, largest.sq * terms),
          magic_p = fitting_magic(usual, largest.sp * terms);
  PointSums<V> sums = {};
  for (unsigned k = 0; k < count; ++k) {
    sums.s += to_grid(magic_s, impulses[k]);
    sums.sq += to_grid(magic_q, impulses[k] * m.get(m.points[k].q));
    sums.sp += to_grid(magic_p, impulses[k] * m.get(m.points[k].p));
  }
  return sums;
}

// The sums of the accumulated impulses, of any size.
template <class V, template <class> class B>
PointSums<V> add_up_impulses(const Manifolds<V, B>& m) {
  V impulses[kPointsMax];
  for (unsigned k = 0; k < m.batch->count; ++k) impulses[k] = m.get(m.points[k].impulse);
  return add_up(m, impulses);
}

// The sums of the accumulated impulses.
template <class V, template <class> class B>
PointSums<V> sums_of_impulses(const Manifolds<V, B>& m) {
  const V magic = m.get(m.batch->impulse_magic);
  PointSums<V> sums = {};
  for (unsigned k = 0; k < m.batch->count; ++k) {
    const PointBatch& point = m.points[k];
    const V impulse = m.get(point.impulse);
    sums.s += to_grid(magic, impulse);
    sums.sq += to_grid(magic, impulse * m.get(point.q));
    sums.sp += to_grid(magic, impulse * m.get(point.p));
  }
  if (any_above(sums.s, m.get(m.batch->impulse_max))) [[unlikely]]
    return add_up_impulses(m);
  return sums;
}

}  // namespace
}  // namespace tumble::sim
