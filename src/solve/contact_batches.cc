#include "src/solve/contact_batches.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "src/math/grid.h"
#include "src/solve/solver_body.h"

namespace tumble::sim {
namespace {

static_assert(kMotionMagic == VelocityGrid::kMagic);
static_assert(sizeof(SolverBody) == kSolverBodyDoubles * sizeof(double));
static_assert(offsetof(SolverBody, inverse_mass) == 6 * sizeof(double));
static_assert(offsetof(SolverBody, inverse_inertia) == 8 * sizeof(double));
static_assert(sizeof(SolverMotion) == kSolverMotionDoubles * sizeof(double));
static_assert(offsetof(SolverMotion, spin) == 3 * sizeof(double));

void set(Lanes* lanes, unsigned lane, const Vec3& v) {
  for (int k = 0; k < 3; ++k) lanes[k].of[lane] = v[k];
}

void fill_geometry(ContactBatch& batch, unsigned lane, const Manifold& m) {
  set(batch.n, lane, m.n);
  set(batch.t1, lane, m.t1);
  set(batch.t2, lane, m.t2);
  set(batch.d, lane, m.d);
  const auto put = [lane](Lanes& lanes, double value) { lanes.of[lane] = value; };
  put(batch.point_count, m.count);
  put(batch.offset, m.offset);
  put(batch.friction, m.friction);
  put(batch.friction_dynamic, m.friction_dynamic);
  put(batch.restitution, m.restitution);
  put(batch.force1, m.force1);
  put(batch.force2, m.force2);
  put(batch.twist, m.twist);
}

void fill_point(PointBatch& batch, unsigned lane, const ManifoldPoint& point) {
  batch.p.of[lane] = point.p;
  batch.q.of[lane] = point.q;
  batch.separation.of[lane] = point.separation;
  batch.impulse.of[lane] = point.impulse;
  batch.load.of[lane] = point.load;
}

double mass_of(const Bodies& bodies, BodyIndex i) {
  return i == kGround || !bodies.moves(i) ? std::numeric_limits<double>::max() : bodies.mass[i];
}

class Batcher {
 public:
  explicit Batcher(World& world)
      : bodies_(world.bodies()),
        gravity_(world.state().def.gravity),
        scratch_(world.mutable_scratch()),
        all_(scratch_.contact_batches),
        ground_(static_cast<std::uint32_t>(scratch_.solver_bodies.size() - 1)) {
    all_.batches.clear();
    all_.points.clear();
    all_.layer_start.clear();
    all_.place.assign(scratch_.manifolds.size(), 0);
    all_.uses.assign(scratch_.solver_bodies.size(), 0);
  }

  // Side by side comes what has as many points.
  void add_layer(std::span<const std::uint32_t> members) {
    all_.layer_start.push_back(static_cast<std::uint32_t>(all_.batches.size()));
    count_uses(members);
    std::vector<std::uint32_t>& order = all_.order;
    order.assign(members.begin(), members.end());
    std::ranges::sort(order, {}, [&](std::uint32_t k) { return scratch_.manifolds[k].count; });
    for (std::size_t begin = 0; begin < order.size(); begin += kLanes) {
      add_batch(std::span(order).subspan(begin, std::min<std::size_t>(kLanes, order.size() - begin)));
    }
    forget_uses(members);
  }
  void finish() { all_.layer_start.push_back(static_cast<std::uint32_t>(all_.batches.size())); }

 private:
  // Manifolds of one layer are solved at the same time, so each sees only its share of a body's mass.
  void count_uses(std::span<const std::uint32_t> members) {
    for (const std::uint32_t k : members) {
      ++all_.uses[solver_row(scratch_, scratch_.manifolds[k].a)];
      ++all_.uses[scratch_.manifolds[k].b];
    }
  }
  void forget_uses(std::span<const std::uint32_t> members) {
    for (const std::uint32_t k : members) {
      all_.uses[solver_row(scratch_, scratch_.manifolds[k].a)] = 0;
      all_.uses[scratch_.manifolds[k].b] = 0;
    }
  }

  // Up to kLanes manifolds, the last of which has the most points.
  void add_batch(std::span<const std::uint32_t> group) {
    const auto number = static_cast<std::uint32_t>(all_.batches.size());
    ContactBatch& batch = all_.batches.emplace_back();
    std::fill_n(batch.a, kLanes, ground_);
    std::fill_n(batch.b, kLanes, ground_);
    batch.used = static_cast<std::uint32_t>(group.size());
    batch.first = static_cast<std::uint32_t>(all_.points.size());
    batch.count = scratch_.manifolds[group.back()].count;
    all_.points.resize(all_.points.size() + batch.count);
    for (unsigned lane = 0; lane < group.size(); ++lane) {
      const Manifold& m = scratch_.manifolds[group[lane]];
      all_.place[group[lane]] = number * kLanes + lane;
      fill_geometry(batch, lane, m);
      fill_masses(batch, lane, m);
      std::size_t at = batch.first;
      for (const ManifoldPoint& point : points_of(std::as_const(scratch_), m)) {
        fill_point(all_.points[at++], lane, point);
      }
    }
  }

  void fill_masses(ContactBatch& batch, unsigned lane, const Manifold& m) {
    batch.a[lane] = solver_row(scratch_, m.a);
    batch.b[lane] = m.b;
    batch.split_a.of[lane] = m.a == kGround ? 1 : all_.uses[m.a];
    batch.split_b.of[lane] = all_.uses[m.b];
    const double lighter = std::min(mass_of(bodies_, m.a), mass_of(bodies_, m.b));
    batch.impulse_magic.of[lane] = VelocityGrid::kMagic * power_of_two(lighter);
    const bool a_falls = m.a != kGround && bodies_.moves(m.a), b_falls = bodies_.moves(m.b);
    batch.acceleration.of[lane] = a_falls == b_falls ? 0 : dot(gravity_, m.n) * (b_falls ? 1 : -1);
  }

  const Bodies& bodies_;
  const Vec3& gravity_;
  Scratch& scratch_;
  ContactBatches& all_;
  std::uint32_t ground_;
};

bool bounces(const ContactBatches& all, const ContactBatch& batch) {
  for (std::uint32_t k = batch.first; k < batch.first + batch.count; ++k) {
    const Lanes& approach = all.points[k].approach;
    if (std::any_of(approach.of, approach.of + kLanes, [](double v) { return v <= -kBounceMin; })) return true;
  }
  return false;
}

}  // namespace

void batch_contacts(World& world) {
  Batcher batcher(world);
  const Scratch& scratch = world.scratch();
  for (std::size_t layer = 0; layer + 1 < scratch.layer_start.size(); ++layer) {
    batcher.add_layer(layer_of(scratch, layer));
  }
  batcher.finish();
}

void mark_bounces(ContactBatches& all) {
  for (ContactBatch& batch : all.batches) batch.bounces = bounces(all, batch);
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
