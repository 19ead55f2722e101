#include "src/layered/batch/batch_contacts.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "src/base/check.h"
#include "src/layered/batch/cut_layers.h"
#include "src/layered/batch/share_layer.h"
#include "src/layered/islands/awake_links.h"
#include "src/math/grid.h"
#include "src/sharing/key_counts.h"

namespace tumble::sim {
namespace {

// The manifolds of layers that follow one another.
struct LayerList {
  std::span<const std::uint32_t> members;  // layer by layer
  std::span<const std::uint32_t> start;    // by layer, in `members`; one more at the end
  std::uint32_t hard_from = 0;             // layers from this one on belong to hard islands
  bool of_fast_pairs = false;

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(start.size() - 1); }
};

// Groups the manifolds of each layer into batches by their number of points: lanes of a batch take as long as the one
// with the most points.
class Grouping {
 public:
  Grouping(const LayerList& layers, std::span<const Manifold> manifolds, ContactBatches& all)
      : layers_(layers), manifolds_(manifolds), all_(all) {
    all_.layer_start.assign(1, 0);
    std::uint32_t batches = 0;
    for (std::uint32_t layer = 0; layer < layers_.count(); ++layer) {
      const std::uint32_t here = (layers_.start[layer + 1] - layers_.start[layer] + kLanes - 1) / kLanes;
      widest_ = std::max(widest_, here);
      all_.layer_start.push_back(batches += here);
    }
    all_.place.resize(manifolds.size());
    all_.order.resize(layers_.members.size());
    resize_anew(all_.batches, batches);
    all_.sides.resize(batches);
    all_.counts.resize(batches + 1);
  }

  // Batches of the layer that has the most of them.
  [[nodiscard]] std::uint32_t widest() const { return widest_; }

  // What one of several workers does: orders the manifolds. memory: of KeyCounts.
  void group(std::vector<std::uint32_t>& memory, const Worker& worker) {
    KeyCounts counts(memory, std::size_t{layers_.count()} * kGroups, worker);
    const Worker::Share own = worker.share(layers_.members.size());
    for_members(own, [&](std::uint32_t group, std::uint32_t /*manifold*/) { counts.add(group); });
    counts.find_places();
    for_members(own, [&](std::uint32_t group, std::uint32_t manifold) { all_.order[counts.take(group)] = manifold; });
    worker.meet();
  }

  // When all manifolds are grouped, for the batches of a share.
  void place_batches(const Worker::Share& share) {
    for_batches(share, [&](std::uint32_t k, std::uint32_t layer) {
      ContactBatch& batch = all_.batches[k];
      batch.members = layers_.start[layer] + (k - all_.layer_start[layer]) * kLanes;
      batch.used = std::min<std::uint32_t>(kLanes, layers_.start[layer + 1] - batch.members);
      batch.hard = batch.turns = layer >= layers_.hard_from ? kAllLanes : 0;
      batch.loose = 0;
      batch.fast = layers_.of_fast_pairs;
      batch.count = 0;
      for (unsigned lane = 0; lane < batch.used; ++lane) {
        const std::uint32_t m = all_.order[batch.members + lane];
        batch.count = std::max(batch.count, manifolds_[m].count);
        all_.place[m] = k * kLanes + lane;
      }
      SIM_CHECK(batch.count <= kPointsMax, batch.count, kPointsMax);  // the kernels have room for so many
      all_.counts[k] = batch.count;
    });
  }

  // When all layers are grouped: gives each batch its points.
  void place_points() {
    std::uint32_t points = 0;
    for (std::uint32_t& count : all_.counts) points += std::exchange(count, points);
    resize_anew(all_.points, all_.counts.back());
  }

 private:
  static constexpr std::uint8_t kAllLanes = (1U << kLanes) - 1;
  static constexpr std::uint32_t kGroups = 16;  // of a layer: manifolds with 15 points and more are one

  // Calls visit(group, manifold) for members of the layers.
  template <class Visit>
  void for_members(const Worker::Share& share, Visit visit) const {
    std::uint32_t layer = layer_at(layers_.start, share.begin);
    for (auto k = static_cast<std::uint32_t>(share.begin); k < share.end; ++k) {
      while (k >= layers_.start[layer + 1]) ++layer;
      const std::uint32_t m = layers_.members[k];
      visit(layer * kGroups + std::min(kGroups - 1, manifolds_[m].count), m);
    }
  }
  // Calls visit(batch, layer).
  template <class Visit>
  void for_batches(const Worker::Share& share, Visit visit) const {
    std::uint32_t layer = layer_at(all_.layer_start, share.begin);
    for (auto k = static_cast<std::uint32_t>(share.begin); k < share.end; ++k) {
      while (k >= all_.layer_start[layer + 1]) ++layer;
      visit(k, layer);
    }
  }
  // start: by layer. The last layer that begins at an item or before it.
  static std::uint32_t layer_at(std::span<const std::uint32_t> start, std::size_t item) {
    return static_cast<std::uint32_t>(std::upper_bound(start.begin(), start.end(), item) - start.begin()) - 1;
  }

  const LayerList& layers_;
  std::span<const Manifold> manifolds_;
  ContactBatches& all_;
  std::uint32_t widest_ = 0;
};

void set(Lanes* lanes, unsigned lane, const Vec3& v) {
  for (int k = 0; k < 3; ++k) lanes[k].of[lane] = v[k];
}

// Copies manifolds into the lanes of their batches; unused lanes and points are zero.
class Filling {
 public:
  Filling(const WorldState& state, const Scratch& scratch, const LayerList& layers, std::span<const Manifold> manifolds,
          std::span<const ManifoldPoint> points, ContactBatches& all)
      : bodies_(state.bodies),
        gravity_(state.def.gravity),
        fall_(length(gravity_) * state.def.dt / state.def.substeps),
        islands_(scratch.islands),
        layers_(layers),
        manifolds_(manifolds),
        points_(points),
        all_(all),
        ground_(static_cast<std::uint32_t>(bodies_.size())) {}

  void fill(ContactBatch& batch, BatchSides& sides) {
    if (batch.used < kLanes) clear(batch, sides);
    for (unsigned lane = 0; lane < batch.used; ++lane) {
      const Manifold& m = manifolds_[all_.order[batch.members + lane]];
      fill_geometry(batch, lane, m);
      fill_bodies(batch, sides, lane, m);
      PointBatch* to = all_.points.data() + batch.first;
      for (const ManifoldPoint& point : points_.subspan(m.first, m.count)) fill_point(*to++, lane, point);
      for (std::uint32_t k = m.count; k < batch.count; ++k) fill_point(*to++, lane, {});
    }
  }

 private:
  // Zeros the batch, with the ground for bodies.
  void clear(ContactBatch& batch, BatchSides& sides) const {
    ContactBatch empty;
    empty.used = batch.used;
    empty.hard = batch.hard;
    empty.turns = batch.turns;
    empty.fast = batch.fast;
    empty.members = batch.members;
    empty.first = batch.first;
    empty.count = batch.count;
    batch = empty;
    std::fill_n(sides.a, kLanes, ground_);
    std::fill_n(sides.b, kLanes, ground_);
    std::fill_n(sides.visited, kLanes, kNeverDue);
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
    put(batch.sliding, 0);
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
  void fill_bodies(ContactBatch& batch, BatchSides& sides, unsigned lane, const Manifold& m) const {
    sides.a[lane] = m.a == kGround ? ground_ : m.a;
    sides.b[lane] = m.b;
    sides.visited[lane] = 0;
    const BodyIndex mover = mover_of(bodies_, m);
    sides.sweeps[lane] = layers_.of_fast_pairs ? islands_.most_sweeps[islands_.hit[mover]] : islands_.sweeps[mover];
    sides.parting[lane] = static_cast<std::uint8_t>(sides.sweeps[lane] + 1);
    sides.turns[lane] = islands_.turns[mover];
    if (layers_.of_fast_pairs && islands_.has_bar[islands_.hit[mover]] != 0) {
      batch.hard = batch.turns = static_cast<std::uint8_t>(batch.hard | 1U << lane);
    }
    const double lighter = std::min(mass_of(m.a), mass_of(m.b));
    batch.impulse_magic.of[lane] = VelocityGrid::kMagic * power_of_two(lighter);
    const bool a_falls = moves(bodies_, m.a), b_falls = moves(bodies_, m.b);
    batch.slop.of[lane] = std::min(kSlop, kSlopOfHalfExtent * std::min(thickness_of(m.a), thickness_of(m.b)));
    const bool loose = !batch.fast && is_loose(m), keeps_all = !batch.fast && !loose && m.layer >= layers_.hard_from;
    batch.passes_on.of[lane] = keeps_all ? std::numeric_limits<double>::max() : kBorneWeights * (fall_ * lighter);
    if (loose) batch.loose = static_cast<std::uint8_t>(batch.loose | 1U << lane);
    batch.acceleration.of[lane] = a_falls == b_falls ? 0 : dot(gravity_, m.n) * (b_falls ? 1 : -1);
  }
  // Whether bodies meet that touch nothing at rest, so that a substep may begin with what they bear and no more.
  [[nodiscard]] bool is_loose(const Manifold& m) const {
    return m.layer + 1 == layers_.hard_from || m.layer + 1 == layers_.count();
  }
  double mass_of(BodyIndex i) const { return moves(bodies_, i) ? bodies_.mass[i] : std::numeric_limits<double>::max(); }
  double thickness_of(BodyIndex i) const {
    return i == kGround ? std::numeric_limits<double>::max() : Vec3(bodies_.half_extent[i]).minCoeff();
  }

  const Bodies& bodies_;
  const Vec3& gravity_;
  double fall_;  // m/s, what gravity gives in a substep
  const IslandScratch& islands_;
  const LayerList& layers_;
  std::span<const Manifold> manifolds_;
  std::span<const ManifoldPoint> points_;
  ContactBatches& all_;
  std::uint32_t ground_;  // its row in solver_bodies
};

void batch_layers(const WorldState& state, const LayerList& layers, std::span<const Manifold> manifolds,
                  std::span<const ManifoldPoint> points, Scratch& scratch, ContactBatches& all) {
  Workers* const workers = scratch.workers;
  Grouping grouping(layers, manifolds, all);
  const bool shared = !layers.of_fast_pairs && start_shares(state, scratch, layers.count(), all.batches.size());
  const unsigned parts = shared ? scratch.shares.parts : part_count(workers, all.batches.size(), kBatchesAPart);
  make_outcomes(scratch, grouping.widest());
  all.touched.resize(2 * all.order.size());
  all.entries.resize(2 * all.order.size());
  all.touched_start.resize(layers.count());
  all.touched_end.resize(layers.count());
  if (all.uses.size() < parts) all.uses.resize(parts);
  work_together(workers, parts, [&](const Worker& worker) {
    const Worker::Share batches = worker.share(all.batches.size());
    grouping.group(scratch.sweep.next, worker);
    grouping.place_batches(batches);
    worker.meet();
    if (worker.first()) grouping.place_points();
    if (shared) cut_layers(state, scratch, worker);
    worker.meet();
    Filling filling(state, scratch, layers, manifolds, points, all);
    const auto fill = [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        all.batches[k].first = all.counts[k];
        filling.fill(all.batches[k], all.sides[k]);
      }
    };
    if (shared) {
      for_own_batches(scratch, worker, fill);  // so that their lines stay with who solves them
    } else {
      fill(batches.begin, batches.end);
    }
    worker.meet();
    all.uses[worker.part].resize(state.bodies.size());
    const Worker::Share own = worker.share_groups(all.layer_start);
    for (auto k = static_cast<std::uint32_t>(own.begin); k < own.end; ++k) {
      share_layer(state.bodies, k, layers.start[k], all.uses[worker.part], all);
    }
  });
}

}  // namespace

void batch_contacts(const WorldState& state, Scratch& scratch) {
  const SweepGroup& last = scratch.sweep_groups.back();
  const LayerList layers = {scratch.layered, scratch.layer_start, last.hard ? last.begin : last.end};
  batch_layers(state, layers, scratch.manifolds, scratch.manifold_points, scratch, scratch.contact_batches);
}

void batch_fast_contacts(const WorldState& state, Scratch& scratch) {
  const ManifoldList& found = scratch.fast.found;
  std::vector<std::uint32_t>& members = scratch.fast.members;
  members.resize(found.manifolds.size());
  std::iota(members.begin(), members.end(), 0U);
  const std::uint32_t start[] = {0, static_cast<std::uint32_t>(members.size())};
  const LayerList layer = {members, start, 1, true};
  batch_layers(state, layer, found.manifolds, found.points, scratch, scratch.fast.batches);
}

}  // namespace tumble::sim
