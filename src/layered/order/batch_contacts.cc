#include "src/layered/order/batch_contacts.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <span>

#include "src/base/check.h"
#include "src/math/grid.h"

namespace tumble::sim {
namespace {

// Groups the manifolds of a layer into batches by their number of points: lanes of a batch take as long as the one with
// the most points.
class Grouping {
 public:
  Grouping(std::span<const Manifold> manifolds, ContactBatches& all) : manifolds_(manifolds), all_(all) {
    all_.layer_start.assign(1, 0);
    all_.place.resize(manifolds.size());
    all_.order.resize(manifolds.size());
  }

  // Adds a layer behind those before.
  void add_layer(std::span<const std::uint32_t> members, bool hard, double bounce_min) {
    const std::uint32_t begin = members_, batches_before = batches_;
    members_ += static_cast<std::uint32_t>(members.size());
    const auto points_of_member = [&](std::uint32_t k) { return std::min(kManyPoints, manifolds_[k].count); };
    std::array<std::uint32_t, kManyPoints + 2> start{};
    for (const std::uint32_t k : members) ++start[points_of_member(k) + 1];
    for (std::size_t k = 1; k < start.size(); ++k) start[k] += start[k - 1];
    for (const std::uint32_t k : members) all_.order[begin + start[points_of_member(k)]++] = k;
    for (std::uint32_t k = begin; k < members_; k += kLanes) {
      ContactBatch& batch = add_batch(k, std::min<std::uint32_t>(kLanes, members_ - k));
      batch.hard = hard;
      batch.bounce_min = bounce_min;
    }
    all_.layer_start.push_back(batches_);
    widest_ = std::max(widest_, batches_ - batches_before);
  }

  void finish() {
    all_.order.resize(members_);
    all_.batches.resize(batches_);
    all_.points.resize(points_);
    all_.outcomes.resize(std::size_t{widest_} * kLanes * 2);
  }

 private:
  static constexpr std::uint32_t kManyPoints = 15;  // manifolds with more points are grouped together

  ContactBatch& add_batch(std::uint32_t members, std::uint32_t used) {
    if (all_.batches.size() == batches_) all_.batches.emplace_back();
    ContactBatch& batch = all_.batches[batches_];
    batch.used = used;
    batch.members = members;
    batch.first = points_;
    batch.count = 0;
    std::fill_n(batch.visited, kLanes, 0U);
    for (unsigned lane = 0; lane < used; ++lane) {
      const std::uint32_t k = all_.order[members + lane];
      batch.count = std::max(batch.count, manifolds_[k].count);
      all_.place[k] = batches_ * kLanes + lane;
    }
    SIM_CHECK(batch.count <= kPointsMax, batch.count, kPointsMax);  // the kernels have room for so many
    points_ += batch.count;
    ++batches_;
    return batch;
  }

  std::span<const Manifold> manifolds_;
  ContactBatches& all_;
  std::uint32_t members_ = 0, batches_ = 0, points_ = 0, widest_ = 0;
};

void set(Lanes* lanes, unsigned lane, const Vec3& v) {
  for (int k = 0; k < 3; ++k) lanes[k].of[lane] = v[k];
}

// Copies manifolds into the lanes of their batches; unused lanes and points are zero.
class Filling {
 public:
  Filling(const WorldState& state, std::span<const Manifold> manifolds, std::span<const ManifoldPoint> points,
          ContactBatches& all)
      : bodies_(state.bodies),
        gravity_(state.def.gravity),
        manifolds_(manifolds),
        points_(points),
        all_(all),
        ground_(static_cast<std::uint32_t>(bodies_.size())) {}

  void fill(ContactBatch& batch) {
    if (batch.used < kLanes) clear(batch);
    for (unsigned lane = 0; lane < batch.used; ++lane) {
      const Manifold& m = manifolds_[all_.order[batch.members + lane]];
      fill_geometry(batch, lane, m);
      fill_bodies(batch, lane, m);
      PointBatch* to = all_.points.data() + batch.first;
      for (const ManifoldPoint& point : points_.subspan(m.first, m.count)) fill_point(*to++, lane, point);
      for (std::uint32_t k = m.count; k < batch.count; ++k) fill_point(*to++, lane, {});
    }
  }

 private:
  // Zeros the batch, with the ground for bodies.
  void clear(ContactBatch& batch) const {
    ContactBatch empty;
    empty.used = batch.used;
    empty.hard = batch.hard;
    empty.bounce_min = batch.bounce_min;
    empty.members = batch.members;
    empty.first = batch.first;
    empty.count = batch.count;
    batch = empty;
    std::fill_n(batch.a, kLanes, ground_);
    std::fill_n(batch.b, kLanes, ground_);
    std::fill_n(all_.points.begin() + batch.first, batch.count, PointBatch{});
  }

  static void fill_geometry(ContactBatch& batch, unsigned lane, const Manifold& m) {
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
    put(batch.split_a, 0);
    put(batch.split_b, 0);
  }
  static void fill_point(PointBatch& batch, unsigned lane, const ManifoldPoint& point) {
    batch.p.of[lane] = point.p;
    batch.q.of[lane] = point.q;
    batch.separation.of[lane] = point.separation;
    batch.impulse.of[lane] = point.impulse;
    batch.load.of[lane] = point.load;
  }
  void fill_bodies(ContactBatch& batch, unsigned lane, const Manifold& m) const {
    batch.a[lane] = m.a == kGround ? ground_ : m.a;
    batch.b[lane] = m.b;
    const double lighter = std::min(mass_of(m.a), mass_of(m.b));
    batch.impulse_magic.of[lane] = VelocityGrid::kMagic * power_of_two(lighter);
    const bool a_falls = m.a != kGround && bodies_.moves(m.a), b_falls = bodies_.moves(m.b);
    batch.slop.of[lane] = std::min(kSlop, kSlopOfHalfExtent * std::min(thickness_of(m.a), thickness_of(m.b)));
    batch.acceleration.of[lane] = a_falls == b_falls ? 0 : dot(gravity_, m.n) * (b_falls ? 1 : -1);
  }
  double mass_of(BodyIndex i) const {
    return i == kGround || !bodies_.moves(i) ? std::numeric_limits<double>::max() : bodies_.mass[i];
  }
  double thickness_of(BodyIndex i) const {
    return i == kGround ? std::numeric_limits<double>::max() : Vec3(bodies_.half_extent[i]).minCoeff();
  }

  const Bodies& bodies_;
  const Vec3& gravity_;
  std::span<const Manifold> manifolds_;
  std::span<const ManifoldPoint> points_;
  ContactBatches& all_;
  std::uint32_t ground_;  // its row in solver_bodies
};

// Lists for each layer its moving bodies with their outcomes, and sets the split of masses. All manifolds of a layer
// start from one velocity of a body and correct it fully, so k manifolds together would overshoot by k times. Mass
// splitting gives each manifold a body of 1/k of the mass; the k outcomes then add up to one correction (Tonge,
// Benevolenski and Voroshilov 2012, Mass splitting for jitter-free parallel rigid body simulation).
class Sharing {
 public:
  Sharing(const WorldState& state, ContactBatches& all) : bodies_(state.bodies), all_(all) {
    all_.touched.clear();
    all_.touched_start.assign(1, 0);
    all_.entries.resize(2 * all_.order.size());
    all_.uses.assign(bodies_.size(), 0);
  }

  void add_layer(std::size_t layer) {
    const std::uint32_t begin = all_.layer_start[layer], end = all_.layer_start[layer + 1];
    for_sides(begin, end, [&](BodyIndex i, Lanes&, unsigned, std::uint32_t) {
      if (all_.uses[i]++ == 0) all_.touched.push_back({i, 0, 0});
    });
    const std::span<BodyOutcomes> touched = std::span(all_.touched).subspan(all_.touched_start.back());
    for (std::uint32_t k = 0; k < touched.size(); ++k) {
      BodyOutcomes& of = touched[k];
      of.begin = of.end = entries_;
      entries_ += all_.uses[of.body];
      all_.uses[of.body] = k;
    }
    for_sides(begin, end, [&](BodyIndex i, Lanes&, unsigned, std::uint32_t row) {
      all_.entries[touched[all_.uses[i]].end++] = row;
    });
    for_sides(begin, end, [&](BodyIndex i, Lanes& split, unsigned lane, std::uint32_t) {
      const BodyOutcomes& of = touched[all_.uses[i]];
      split.of[lane] = of.end - of.begin;
    });
    for (const BodyOutcomes& of : touched) all_.uses[of.body] = 0;
    all_.touched_start.push_back(static_cast<std::uint32_t>(all_.touched.size()));
  }

 private:
  // Calls visit(body, split, lane, row of outcomes) for both bodies of every manifold of batches [begin, end), if they
  // move.
  template <class Visit>
  void for_sides(std::uint32_t begin, std::uint32_t end, Visit visit) {
    for (std::uint32_t k = begin; k < end; ++k) {
      ContactBatch& batch = all_.batches[k];
      for (unsigned lane = 0; lane < batch.used; ++lane) {
        const std::uint32_t row = 2 * ((k - begin) * kLanes + lane);
        if (batch.a[lane] < bodies_.size() && bodies_.moves(batch.a[lane])) {
          visit(batch.a[lane], batch.split_a, lane, row);
        }
        if (bodies_.moves(batch.b[lane])) visit(batch.b[lane], batch.split_b, lane, row + 1);
      }
    }
  }

  const Bodies& bodies_;
  ContactBatches& all_;
  std::uint32_t entries_ = 0;
};

}  // namespace

void batch_contacts(const WorldState& state, Scratch& scratch) {
  ContactBatches& all = scratch.contact_batches;
  Grouping grouping(scratch.manifolds, all);
  for (const SweepGroup& group : scratch.sweep_groups) {
    for (std::uint32_t layer = group.begin; layer < group.end; ++layer) {
      grouping.add_layer(layer_of(scratch, layer), group.hard, kBounceMin);
    }
  }
  grouping.finish();
  for_ranges(scratch.workers, all.batches.size(), kBatchesAPart, [&](std::size_t begin, std::size_t end) {
    Filling filling(state, scratch.manifolds, scratch.manifold_points, all);
    for (std::size_t k = begin; k < end; ++k) filling.fill(all.batches[k]);
  });
  Sharing sharing(state, all);
  for (std::size_t layer = 0; layer + 1 < all.layer_start.size(); ++layer) sharing.add_layer(layer);
}

void batch_fast_contacts(const WorldState& state, Scratch& scratch, bool hard) {
  const ManifoldList& found = scratch.fast.found;
  ContactBatches& all = scratch.fast.batches;
  std::vector<std::uint32_t>& members = scratch.fast.members;
  members.resize(found.manifolds.size());
  std::iota(members.begin(), members.end(), 0U);
  Grouping grouping(found.manifolds, all);
  grouping.add_layer(members, hard, kFastBounceMin);
  grouping.finish();
  Filling filling(state, found.manifolds, found.points, all);
  for (ContactBatch& batch : all.batches) filling.fill(batch);
  Sharing(state, all).add_layer(0);
}

}  // namespace tumble::sim
