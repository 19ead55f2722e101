#include "src/layered/batch/cut_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "src/layered/batch/share_layer.h"

namespace tumble::sim {
namespace {

constexpr std::size_t kSweepBatches = 48;  // of all layers, that pay for one more worker
constexpr std::size_t kSamples = 1024;     // contacts that choose the axis
constexpr double kEnd = std::numeric_limits<double>::max();

// Of contacts all over the scene: the axis across which a cut meets the fewest of them.
int axis_to_cut(const Bodies& bodies, const Scratch& scratch) {
  const ContactBatches& all = scratch.contact_batches;
  double low[3], high[3], crossed[3] = {};
  std::fill_n(low, 3, std::numeric_limits<double>::max());
  std::fill_n(high, 3, std::numeric_limits<double>::lowest());
  const std::size_t step = 1 + all.batches.size() / kSamples;
  for (std::size_t k = 0; k < all.batches.size(); k += step) {
    const Manifold& m = scratch.manifolds[all.order[all.batches[k].members]];
    const bool both = m.a != kGround && bodies.moves(m.a) && bodies.moves(m.b);
    const Vec3 x = bodies.position[m.b], way = both ? Vec3(bodies.position[m.a] - x) : Vec3(Vec3::Zero());
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], x[axis]);
      high[axis] = std::max(high[axis], x[axis]);
      crossed[axis] += std::fabs(way[axis]);
    }
  }
  const auto cuts = [&](int axis) { return (crossed[axis] + 1e-9) / (high[axis] - low[axis] + 1e-9); };
  int best = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (cuts(axis) < cuts(best)) best = axis;
  }
  return best;
}

// start: by layer, its first batch; one more at the end.
std::uint32_t largest_layer(std::span<const std::uint32_t> start) {
  std::uint32_t largest = 0;
  for (std::uint32_t k = 1; k + 1 < start.size(); ++k) {
    if (start[k + 1] - start[k] > start[largest + 1] - start[largest]) largest = k;
  }
  return largest;
}

// What one of the workers does to cut the layers.
class Cutting {
 public:
  Cutting(const WorldState& state, Scratch& scratch, const Worker& worker)
      : bodies_(state.bodies),
        manifolds_(scratch.manifolds),
        all_(scratch.contact_batches),
        shares_(scratch.shares),
        worker_(worker),
        axis_(scratch.shares.axis),
        largest_(largest_layer(all_.layer_start)),
        places_(scratch.shares.places[worker.part]) {}

  void cut() {
    const Worker::Share own = worker_.share_groups(all_.layer_start);
    for (auto layer = static_cast<std::uint32_t>(own.begin); layer < own.end; ++layer) cut_layer(layer);
  }

 private:
  // Twice the place of the middle of a batch.
  [[nodiscard]] double place_of_batch(std::uint32_t k) const {
    const ContactBatch& batch = all_.batches[k];
    const auto place = [&](std::uint32_t m) { return bodies_.position[manifolds_[all_.order[m]].b][axis_]; };
    return place(batch.members) + place(batch.members + batch.used - 1);
  }

  // Gives every worker as many batches of a layer, side by side.
  void cut_layer(std::uint32_t layer) {
    const std::uint32_t begin = all_.layer_start[layer], count = all_.layer_start[layer + 1] - begin;
    const unsigned parts = worker_.parts;
    // Worker w has the ranks r with (2 r + 1) parts / (2 count) = w, so that few batches lie in the middle of a share.
    std::array<std::uint32_t, kSharesMost + 1> from{};
    for (std::uint64_t w = 0; w <= parts; ++w) {
      from[w] = static_cast<std::uint32_t>((2 * w * count + parts - 1) / (2 * parts));
    }
    for (unsigned w = 0; w < parts; ++w) shares_.first[std::size_t{layer} * parts + w] = begin + from[w];
    places_.clear();
    for (std::uint32_t k = begin; k < begin + count; ++k) places_.emplace_back(place_of_batch(k), k);
    std::uint32_t* const own = shares_.order.data() + begin;
    if (std::ranges::is_sorted(places_)) {
      std::iota(own, own + count, begin);
      if (layer == largest_) {
        for (unsigned w = 1; w < parts; ++w) shares_.cuts[w - 1] = from[w] < count ? places_[from[w]].first : kEnd;
      }
      return;
    }
    // The first place of each share; then the batches go to their shares, and stay in order there.
    std::array<std::pair<double, std::uint32_t>, kSharesMost> cuts;
    places_.resize(std::size_t{2} * count);
    const auto ranked = places_.begin() + count;
    std::copy_n(places_.begin(), count, ranked);
    for (unsigned w = 1; w < parts; ++w) {
      if (from[w] < count) std::nth_element(ranked + from[w - 1], ranked + from[w], places_.end());
      cuts[w - 1] = from[w] < count ? ranked[from[w]] : std::pair(kEnd, 0U);
      if (layer == largest_) shares_.cuts[w - 1] = cuts[w - 1].first;
    }
    for (std::uint32_t r = 0; r < count; ++r) {
      const auto w = std::upper_bound(cuts.begin(), cuts.begin() + (parts - 1), places_[r]) - cuts.begin();
      own[from[static_cast<std::size_t>(w)]++] = places_[r].second;
    }
  }

  const Bodies& bodies_;
  std::span<const Manifold> manifolds_;
  const ContactBatches& all_;
  SweepShares& shares_;
  Worker worker_;
  int axis_;
  std::uint32_t largest_;  // layer
  OwnList<std::pair<double, std::uint32_t>>& places_;
};

}  // namespace

bool start_shares(const WorldState& state, Scratch& scratch, std::size_t layers, std::size_t batches) {
  SweepShares& shares = scratch.shares;
  shares.copies.clear();
  shares.parts = 1;
  if (scratch.layers != nullptr) return false;  // whoever looks at layers wants the rows of bodies
  shares.parts = std::min(kSharesMost, part_count(scratch.workers, batches, kSweepBatches));
  if (shares.parts == 1) return false;
  const std::size_t n = state.bodies.size(), pieces = layers * shares.parts;
  shares.rows = static_cast<std::uint32_t>(n + 1);
  shares.order.resize(batches);
  shares.first.resize(pieces + 1);
  shares.first.back() = static_cast<std::uint32_t>(batches);
  shares.users.resize(n);
  shares.copies_before.resize(n);
  shares.cuts.resize(shares.parts - 1);
  shares.counts.assign(shares.parts + 1, 0);
  shares.heirs.resize(pieces);
  shares.urgent.resize(pieces);
  shares.touched_first.resize(pieces + 1);
  make_outcomes(scratch, batches);  // workers are not all in one layer
  if (shares.places.size() < shares.parts) shares.places.resize(shares.parts);
  return true;
}

void cut_layers(const WorldState& state, Scratch& scratch, const Worker& worker) {
  if (worker.first()) scratch.shares.axis = axis_to_cut(state.bodies, scratch);
  worker.meet();
  Cutting(state, scratch, worker).cut();
}

}  // namespace tumble::sim
