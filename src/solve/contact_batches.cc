#include "src/solve/contact_batches.h"

#include <algorithm>
#include <cstddef>

#include "src/solve/solver_body.h"

namespace tumble::sim {
namespace {

static_assert(sizeof(SolverBody) == kSolverBodyDoubles * sizeof(double));
static_assert(offsetof(SolverBody, inverse_mass) == 6 * sizeof(double));
static_assert(offsetof(SolverBody, inverse_inertia) == 8 * sizeof(double));
static_assert(sizeof(SolverMotion) == kSolverMotionDoubles * sizeof(double));
static_assert(offsetof(SolverMotion, spin) == 3 * sizeof(double));

void set(Lanes* lanes, unsigned lane, const Vec3& v) {
  for (int k = 0; k < 3; ++k) lanes[k].of[lane] = v[k];
}

void fill_lane(ContactBatch& batch, unsigned lane, const Manifold& m) {
  set(batch.n, lane, m.n);
  set(batch.t1, lane, m.t1);
  set(batch.t2, lane, m.t2);
  set(batch.d, lane, m.d);
  const auto put = [lane](Lanes& lanes, double value) { lanes.of[lane] = value; };
  put(batch.offset, m.offset);
  put(batch.split_a, m.split_a);
  put(batch.split_b, m.split_b);
  put(batch.friction, m.friction);
  put(batch.friction_dynamic, m.friction_dynamic);
  put(batch.restitution, m.restitution);
  put(batch.acceleration, m.acceleration);
  put(batch.centre_p, m.centre_p);
  put(batch.centre_q, m.centre_q);
  put(batch.radius, m.radius);
  for (int k = 0; k < 6; ++k) put(batch.friction_inverse[k], m.friction_inverse[k]);
  for (int k = 0; k < 6; ++k) put(batch.response[k], m.response[k]);
  put(batch.relaxation, m.relaxation);
  put(batch.impulse_magic, m.impulse_magic);
  put(batch.force1, m.force1);
  put(batch.force2, m.force2);
  put(batch.twist, m.twist);
}

void fill_point(PointBatch& batch, unsigned lane, const ManifoldPoint& point) {
  batch.p.of[lane] = point.p;
  batch.q.of[lane] = point.q;
  batch.separation.of[lane] = point.separation;
  batch.impulse.of[lane] = point.impulse;
  batch.mass.of[lane] = point.mass;
  batch.approach.of[lane] = point.approach;
  batch.peak.of[lane] = point.peak;
}

// One batch out of up to kLanes manifolds, whose last has the most points.
void add_batch(Scratch& scratch, std::span<const std::uint32_t> group) {
  ContactBatches& all = scratch.contact_batches;
  const auto ground = static_cast<std::uint32_t>(scratch.solver_bodies.size() - 1);
  const auto number = static_cast<std::uint32_t>(all.batches.size());
  ContactBatch& batch = all.batches.emplace_back();
  std::fill_n(batch.a, kLanes, ground);
  std::fill_n(batch.b, kLanes, ground);
  batch.used = static_cast<std::uint32_t>(group.size());
  batch.first = static_cast<std::uint32_t>(all.points.size());
  batch.count = scratch.manifolds[group.back()].count;
  all.points.resize(all.points.size() + batch.count);
  for (unsigned lane = 0; lane < group.size(); ++lane) {
    const Manifold& m = scratch.manifolds[group[lane]];
    all.place[group[lane]] = number * kLanes + lane;
    batch.a[lane] = solver_row(scratch, m.a);
    batch.b[lane] = m.b;
    fill_lane(batch, lane, m);
    const std::span<const ManifoldPoint> points = points_of(std::as_const(scratch), m);
    for (std::size_t k = 0; k < points.size(); ++k) {
      fill_point(all.points[batch.first + k], lane, points[k]);
      batch.bounces = batch.bounces || points[k].approach <= -kBounceMin;
    }
  }
}

}  // namespace

void batch_contacts(Scratch& scratch) {
  ContactBatches& all = scratch.contact_batches;
  all.batches.clear();
  all.points.clear();
  all.layer_start.clear();
  all.place.assign(scratch.manifolds.size(), 0);
  std::vector<std::uint32_t>& order = all.order;
  for (std::size_t layer = 0; layer + 1 < scratch.layer_start.size(); ++layer) {
    all.layer_start.push_back(static_cast<std::uint32_t>(all.batches.size()));
    const std::span<const std::uint32_t> members = layer_of(scratch, layer);
    order.assign(members.begin(), members.end());
    std::ranges::stable_sort(order, {}, [&](std::uint32_t k) { return scratch.manifolds[k].count; });
    for (std::size_t begin = 0; begin < order.size(); begin += kLanes) {
      add_batch(scratch, std::span(order).subspan(begin, std::min<std::size_t>(kLanes, order.size() - begin)));
    }
  }
  all.layer_start.push_back(static_cast<std::uint32_t>(all.batches.size()));
}

void store_contacts(Scratch& scratch) {
  const ContactBatches& all = scratch.contact_batches;
  for (const std::uint32_t k : scratch.layered) {
    Manifold& m = scratch.manifolds[k];
    const ContactBatch& batch = all.batches[all.place[k] / kLanes];
    const unsigned lane = all.place[k] % kLanes;
    m.force1 = batch.force1.of[lane];
    m.force2 = batch.force2.of[lane];
    m.twist = batch.twist.of[lane];
    std::size_t at = batch.first;
    for (ManifoldPoint& point : points_of(scratch, m)) {
      point.impulse = all.points[at].impulse.of[lane];
      point.separation = all.points[at].separation.of[lane];
      ++at;
    }
  }
}

ContactWork all_contacts(Scratch& scratch, double substep_s) {
  ContactBatches& all = scratch.contact_batches;
  return {all.batches.data(),
          all.batches.size(),
          all.points.data(),
          reinterpret_cast<double*>(scratch.solver_bodies.data()),
          reinterpret_cast<double*>(scratch.solver_sums.data()),
          substep_s};
}

ContactWork contacts_of_layer(Scratch& scratch, std::size_t layer, double substep_s) {
  ContactWork work = all_contacts(scratch, substep_s);
  const std::uint32_t begin = scratch.contact_batches.layer_start[layer];
  work.batches += begin;
  work.count = scratch.contact_batches.layer_start[layer + 1] - begin;
  return work;
}

}  // namespace tumble::sim
