#pragma once

// The fields of a manifold that stay fixed during a step, for any number of lanes. lane_vector.h says who may include
// this.

#include "src/kernels/contacts/contact_lanes.h"
#include "src/kernels/contacts/contact_levers_impl.h"

namespace tumble::sim {
namespace {

// Relaxation of the Jacobi passes over a manifold's points, divided by the largest row sum of the points' matrix. The
// passes converge while relaxation times the largest eigenvalue stays below 2, and a row sum is a bound of the
// eigenvalue (Gershgorin), so 1.8 is safe. The points between two bars lie so close that they act as one point; the row
// sum is then the eigenvalue itself, and 1.8 would overshoot by 0.8 in every pass: 1.4.
constexpr double kOverRelaxation = 1.8, kHardRelaxation = 1.4;

// m/s that a remembered impulse may give the lighter body: in all, and beyond the load that it bears. Contacts that
// carry weights for a substep need far less.
constexpr double kWarmSpeedMax = 16, kWarmExcessMax = 4;

// Sums of magnitudes on the grid of motions are exact up to here; an entry of a row is about 1 at most.
constexpr double kRowSumMax = 16384;

// The change of (u, W1, W2) by a unit of force along a direction, or of pure torque.
template <class V>
struct Response {
  V u, w1, w2;
};
template <class V>
Response<V> response_to(const Manifolds<V>& m, const Wrench<V>& wrench) {
  const V split_a = m.get(m.batch->split_a), split_b = m.get(m.batch->split_b);
  const Space<V> va = velocity_of(m.a, wrench.force) * -split_a, vb = velocity_of(m.b, wrench.force) * split_b;
  const Space<V> wa = spin_of(m.a, reaction_torque(m, wrench)) * -split_a, wb = spin_of(m.b, wrench.torque) * split_b;
  const Space<V> u = (vb - va) - cross(wa, m.d), w = wb - wa;
  return {dot(u, m.n), dot(w, m.t1), dot(w, m.t2)};
}

// `value` in the lanes whose manifold has this point, 0 in the others.
template <class V>
V where_present(const Manifolds<V>& m, unsigned point, V value) {
  return m.get(m.batch->point_count) > static_cast<double>(point) ? value : V{};
}

// The largest coordinate of a point, m; at least 1. Sets the impulse from which add_up has to look for a grid; half of
// that, so that no rounding of sums shows in the comparison.
template <class V>
V find_reach(const Manifolds<V>& m) {
  V reach = V{} + 1.0;
  for (unsigned k = 0; k < m.batch->count; ++k) {
    reach = larger(reach, larger(magnitude(m.get(m.points[k].p)), magnitude(m.get(m.points[k].q))));
  }
  m.set(m.batch->impulse_max, 0.5 * m.get(m.batch->impulse_magic) / (reach * terms_of(m)));
  return reach;
}

// Friction acts at the mean of the points; the radius is the mean distance of the points from there.
template <class V>
void find_friction_centre(const Manifolds<V>& m, V reach) {
  ContactBatch& batch = *m.batch;
  V p = V{}, q = V{}, radius = V{};
  const V count = larger(V{} + 1.0, m.get(batch.point_count));
  const V magic = fitting_magic(V{} + kMotionMagic, 4.0 * reach * count);  // no distance from the mean is larger
  for (unsigned k = 0; k < batch.count; ++k) {
    p += to_grid(magic, m.get(m.points[k].p));
    q += to_grid(magic, m.get(m.points[k].q));
  }
  p = p / count;
  q = q / count;
  for (unsigned k = 0; k < batch.count; ++k) {
    const V x = m.get(m.points[k].p) - p, y = m.get(m.points[k].q) - q;
    radius += where_present(m, k, to_grid(magic, square_root(x * x + y * y)));
  }
  m.set(batch.centre_p, p);
  m.set(batch.centre_q, q);
  m.set(batch.radius, radius / count);
}

// The inverse of the symmetric matrix k = (11, 12, 13, 22, 23, 33); zeros in a lane that is not used.
template <class V>
void invert_friction(const Manifolds<V>& m, const V k[6]) {
  const V c11 = k[3] * k[5] - k[4] * k[4], c22 = k[0] * k[5] - k[2] * k[2], c33 = k[0] * k[3] - k[1] * k[1];
  const V c12 = k[2] * k[4] - k[1] * k[5], c13 = k[1] * k[4] - k[2] * k[3], c23 = k[1] * k[2] - k[0] * k[4];
  const V scale = 1.0 / (k[5] * c33 + (k[2] * c13 + k[4] * c23));
  const V cofactor[6] = {c11, c12, c13, c22, c23, c33};
  for (int i = 0; i < 6; ++i) m.set(m.batch->friction_inverse[i], where_present(m, 0, cofactor[i] * scale));
}

// The 3 × 3 response of the friction centre: rows t1, t2 and twist about n.
template <class V>
void prepare_friction(const Manifolds<V>& m) {
  const ContactBatch& batch = *m.batch;
  const V split_a = m.get(batch.split_a), split_b = m.get(batch.split_b);
  const Space<V> rb = (m.t1 * m.get(batch.centre_p) + m.t2 * m.get(batch.centre_q)) + m.n * m.get(batch.offset);
  const Space<V> ra = rb + m.d;
  const Space<V> lever_a[3] = {cross(ra, m.t1), cross(ra, m.t2), m.n};
  const Space<V> lever_b[3] = {cross(rb, m.t1), cross(rb, m.t2), m.n};
  Space<V> turn_a[3], turn_b[3];
  for (int k = 0; k < 3; ++k) {
    turn_a[k] = spin_of(m.a, lever_a[k]);
    turn_b[k] = spin_of(m.b, lever_b[k]);
  }
  const V lent_a[2] = {dot(m.a.lent, m.t1), dot(m.a.lent, m.t2)},
          lent_b[2] = {dot(m.b.lent, m.t1), dot(m.b.lent, m.t2)};
  V k[6];
  int at = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      const V of_a = 0.5 * (dot(lever_a[i], turn_a[j]) + dot(lever_a[j], turn_a[i]));
      const V of_b = 0.5 * (dot(lever_b[i], turn_b[j]) + dot(lever_b[j], turn_b[i]));
      V linear = V{};
      if (j < 2) {
        const V none = V{}, mass_a = i == j ? m.a.inverse_mass : none, mass_b = i == j ? m.b.inverse_mass : none;
        linear = split_a * (mass_a - lent_a[i] * lent_a[j]) + split_b * (mass_b - lent_b[i] * lent_b[j]);
      }
      k[at++] = linear + (split_a * of_a + split_b * of_b);
    }
  }
  invert_friction(m, k);
}

// The response of the points' plane to S, Sq and Sp.
template <class V>
struct PlaneResponse {
  Response<V> s, sq, sp;

  explicit PlaneResponse(const Manifolds<V>& m)
      : s(response_to(m, normal_wrench(m, V{} + 1.0, V{}, V{}))),
        sq(response_to(m, normal_wrench(m, V{}, V{} + 1.0, V{}))),
        sp(response_to(m, normal_wrench(m, V{}, V{}, V{} + 1.0))) {}

  Response<V> to_unit_at(V p, V q) const {
    return {s.u + (q * sq.u + p * sp.u), s.w1 + (q * sq.w1 + p * sp.w1), s.w2 + (q * sq.w2 + p * sp.w2)};
  }
};

template <class V>
void prepare_masses(const Manifolds<V>& m, const PlaneResponse<V>& plane) {
  for (unsigned k = 0; k < m.batch->count; ++k) {
    PointBatch& point = m.points[k];
    const V p = m.get(point.p), q = m.get(point.q);
    const Response<V> r = plane.to_unit_at(p, q);
    m.set(point.mass, where_present(m, k, 1.0 / (r.u + (q * r.w1 - p * r.w2))));
  }
}

template <class V>
void prepare_approaches(const Manifolds<V>& m) {
  const Motion<V> motion = relative_motion(m);
  const V u = dot(motion.u, m.n), w1 = dot(motion.w, m.t1), w2 = dot(motion.w, m.t2);
  for (unsigned k = 0; k < m.batch->count; ++k) {
    PointBatch& point = m.points[k];
    m.set(point.peak, V{});
    m.set(point.approach, where_present(m, k, u + (w1 * m.get(point.q) - w2 * m.get(point.p))));
  }
}

// The largest sum over a row of the points' matrix of responses, scaled by their masses; at least 1.
template <class V>
V largest_row_sum(const Manifolds<V>& m, const PlaneResponse<V>& plane) {
  const unsigned count = m.batch->count;
  Response<V> unit[kPointsMax];
  V sum[kPointsMax], largest = V{} + 1.0;
  const auto add = [&](unsigned row, unsigned column, V root) {
    const PointBatch& at = m.points[row];
    const Response<V>& r = unit[column];
    sum[row] += to_grid(V{} + kMotionMagic, magnitude(r.u + (m.get(at.q) * r.w1 - m.get(at.p) * r.w2)) * root);
  };
  for (unsigned i = 0; i < count; ++i) {
    const PointBatch& point = m.points[i];
    unit[i] = plane.to_unit_at(m.get(point.p), m.get(point.q));
    sum[i] = V{};
    for (unsigned j = 0; j <= i; ++j) {
      const V root = square_root(m.get(point.mass) * m.get(m.points[j].mass));
      add(i, j, root);
      if (i != j) add(j, i, root);
    }
  }
  for (unsigned row = 0; row < count; ++row) largest = larger(largest, smaller(sum[row], V{} + kRowSumMax));
  return largest;
}

template <class V>
void prepare_relaxation(const Manifolds<V>& m, const PlaneResponse<V>& plane) {
  V over = V{} + kOverRelaxation;
  if (m.batch->hard != 0) {
    Lanes of;
    for (unsigned lane = 0; lane < kLanes; ++lane) {
      of.of[lane] = (m.batch->hard >> lane & 1U) != 0 ? kHardRelaxation : kOverRelaxation;
    }
    over = m.get(of);
  }
  m.set(m.batch->relaxation, where_present(m, 0, smaller(V{} + 1.0, over / largest_row_sum(m, plane))));
  const V response[6] = {plane.s.u,  plane.sq.u, plane.sp.u, plane.sq.w1, 0.5 * (plane.sp.w1 - plane.sq.w2),
                         plane.sp.w2};
  for (int i = 0; i < 6; ++i) m.set(m.batch->response[i], where_present(m, 0, response[i]));
}

// Of the impulses of a manifold's points and of the loads that they bear, the sums, exact in any order.
template <class V>
struct Borne {
  V impulse, load;
};
template <class V>
Borne<V> impulse_and_load(const Manifolds<V>& m) {
  const ContactBatch& batch = *m.batch;
  const V magic = m.get(batch.impulse_magic), most = m.get(batch.impulse_max);
  V impulse = V{}, load = V{}, loads[kPointsMax];
  for (unsigned k = 0; k < batch.count; ++k) {
    loads[k] = m.get(m.points[k].load);
    impulse += to_grid(magic, m.get(m.points[k].impulse));
    load += to_grid(magic, loads[k]);
  }
  if (any(impulse > most) || any(load > most)) return {add_up_impulses(m).s, add_up(m, loads).s};
  return {impulse, load};
}

// An impulse that stopped an impact in the last step is far larger than the one that carries the weight in this step; a
// warm start from the former would throw the bodies apart, even where they rest again: lent inertia (carry_weights)
// hides how far the impulse could throw a light body.
template <class V>
void forget_impacts(const Manifolds<V>& m) {
  ContactBatch& batch = *m.batch;
  const V yield = larger(m.a.inverse_mass, m.b.inverse_mass);
  const Borne<V> borne = impulse_and_load(m);
  const V before = borne.impulse, load = borne.load;
  const auto bears = load > 0.0;
  const V most = bears ? V{} + kWarmExcessMax : V{} + kWarmSpeedMax;
  const auto too_much = (before - load) * yield > most;
  auto changes = too_much;
  for (unsigned k = 0; k < batch.count; ++k) {
    PointBatch& point = m.points[k];
    const V impulse = m.get(point.impulse);
    const auto stale = too_much | (magnitude(m.get(point.approach)) > kRestingSpeed);
    m.set(point.impulse, stale ? smaller(impulse, m.get(point.load)) : impulse);
    changes = changes | stale;
  }
  const V after = any(changes) ? impulse_and_load(m).impulse : before;
  const V force1 = m.get(batch.force1), force2 = m.get(batch.force2),
          part = after == before ? V{} + 1.0 : after / before;
  const V kept = (magnitude(force1) + magnitude(force2)) * yield > kWarmSpeedMax ? V{} : part;
  const V carried = batch.fast ? V{} : larger(after, load);  // a fast pair's impulse may have stopped a hit
  m.set(batch.passes_on, larger(m.get(batch.passes_on), kBornePart * carried));
  m.set(batch.force1, force1 * kept);
  m.set(batch.force2, force2 * kept);
  m.set(batch.twist, m.get(batch.twist) * kept);
}

// A point that meets within the step meets at the speed that gravity will have given by then: v² = v₀² + 2 a s. With
// today's speed instead, a bouncing body would lose height with every bounce.
template <class V>
void foresee_impact(const Manifolds<V>& m) {
  const V acceleration = m.get(m.batch->acceleration), zero = V{};
  for (unsigned k = 0; k < m.batch->count; ++k) {
    PointBatch& point = m.points[k];
    const V approach = m.get(point.approach), separation = m.get(point.separation);
    const V at_impact = -square_root(larger(zero, approach * approach - 2.0 * acceleration * separation));
    const V still_apart = separation > 0.0 ? at_impact : approach;
    m.set(point.approach, approach < 0.0 ? still_apart : approach);
  }
}

template <class V>
void prepare_responses(const Manifolds<V>& m) {
  prepare_friction(m);
  const PlaneResponse<V> plane(m);
  prepare_masses(m, plane);
  prepare_relaxation(m, plane);
}

template <class V>
void prepare(const ContactWork& work, ContactBatch& batch, unsigned at) {
  Manifolds<V> m(work, batch, at);
  batch.even = (at == 0 || batch.even) && all_of(is_even(m.a) & is_even(m.b));
  find_friction_centre(m, find_reach(m));
  prepare_approaches(m);  // at the step's start
  if (at == 0) batch.levers_turned = false;
  if (work.turn_s > 0) {
    turn_levers(m, work.turn_s);
    m.d = m.space(batch.d);
  }
  prepare_responses(m);
  forget_impacts(m);
  foresee_impact(m);
}

}  // namespace
}  // namespace tumble::sim
