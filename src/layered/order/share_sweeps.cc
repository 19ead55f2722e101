#include "src/layered/order/share_sweeps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "src/layered/order/batch_contacts.h"

namespace tumble::sim {
namespace {

constexpr std::size_t kSweepBatches = 48;  // of all layers, that pay for one more worker
constexpr unsigned kSharesMost = 64;       // workers: a bit each in SweepShares::users
constexpr std::size_t kSamples = 1024;     // contacts that choose the axis

// Of contacts all over the scene: the axis across which a cut meets the fewest of them.
int axis_to_cut(const Bodies& bodies, const ContactBatches& all) {
  double low[3], high[3], crossed[3] = {};
  std::fill_n(low, 3, std::numeric_limits<double>::max());
  std::fill_n(high, 3, std::numeric_limits<double>::lowest());
  const std::size_t step = 1 + all.batches.size() / kSamples;
  for (std::size_t k = 0; k < all.batches.size(); k += step) {
    const std::uint32_t a = all.sides[k].a[0], b = all.sides[k].b[0];
    const bool both = a < bodies.size() && bodies.moves(a) && bodies.moves(b);
    const Vec3 x = bodies.position[b], way = both ? Vec3(bodies.position[a] - x) : Vec3(Vec3::Zero());
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

// What one of the workers does to share the sweeps.
class SharesBuilder {
 public:
  SharesBuilder(const WorldState& state, Scratch& scratch, const Worker& worker, int axis)
      : bodies_(state.bodies),
        scratch_(scratch),
        all_(scratch.contact_batches),
        shares_(scratch.shares),
        worker_(worker),
        axis_(axis),
        own_(worker.share_groups(all_.layer_start)),
        places_(scratch.shares.places[worker.part]) {}

  void build() {
    const Worker::Share rows = worker_.share(bodies_.size());
    std::fill(shares_.users.begin() + static_cast<std::ptrdiff_t>(rows.begin),
              shares_.users.begin() + static_cast<std::ptrdiff_t>(rows.end), std::uint64_t{0});
    for (auto layer = static_cast<std::uint32_t>(own_.begin); layer < own_.end; ++layer) cut_layer(layer);
    worker_.meet();
    find_users();
    worker_.meet();
    place_copies(rows);
    worker_.meet();
    name_rows();
    renew_copies(scratch_, worker_);
    list_touched();
  }

 private:
  [[nodiscard]] std::uint32_t layers() const { return static_cast<std::uint32_t>(all_.touched_start.size()); }

  [[nodiscard]] double place_of_batch(std::uint32_t k) const {
    const BatchSides& sides = all_.sides[k];
    return bodies_.position[sides.b[0]][axis_] + bodies_.position[sides.b[all_.batches[k].used - 1]][axis_];
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
      return;
    }
    // The first place of each share; then the batches go to their shares, and stay in order there.
    std::array<std::pair<double, std::uint32_t>, kSharesMost> cuts;
    places_.insert(places_.end(), places_.begin(), places_.end());
    const auto ranked = places_.begin() + count;
    for (unsigned w = 1; w < parts; ++w) {
      if (from[w] < count) std::nth_element(ranked + from[w - 1], ranked + from[w], places_.end());
      cuts[w - 1] = from[w] < count ? ranked[from[w]] : std::pair(std::numeric_limits<double>::max(), 0U);
    }
    for (std::uint32_t r = 0; r < count; ++r) {
      const auto w = std::upper_bound(cuts.begin(), cuts.begin() + (parts - 1), places_[r]) - cuts.begin();
      own[from[static_cast<std::size_t>(w)]++] = places_[r].second;
    }
  }

  // Calls visit(row) for both sides of a batch's manifolds, where the body moves.
  template <class Visit>
  void for_sides(std::uint32_t k, Visit visit) {
    BatchSides& sides = all_.sides[k];
    for (unsigned lane = 0; lane < all_.batches[k].used; ++lane) {
      for (std::uint32_t* const row : {&sides.a[lane], &sides.b[lane]}) {
        if (*row < bodies_.size() && bodies_.moves(*row)) visit(*row);
      }
    }
  }

  void find_users() {
    const std::uint64_t bit = std::uint64_t{1} << worker_.part;
    const auto use = [&](std::uint32_t row) { shared::set_bits(shares_.users[row], bit); };
    for (std::uint32_t layer = 0; layer < layers(); ++layer) {
      for (const std::uint32_t k : shares_.batches_of(layer, worker_.part)) for_sides(k, use);
    }
  }

  static std::uint32_t copies_of(std::uint64_t users) {
    return users == 0 ? 0 : static_cast<std::uint32_t>(std::popcount(users)) - 1;
  }
  void place_copies(const Worker::Share& rows) {
    std::uint32_t count = 0;
    for (std::size_t i = rows.begin; i < rows.end; ++i) count += copies_of(shares_.users[i]);
    shares_.counts[worker_.part + 1] = count;
    worker_.meet();
    if (worker_.first()) {
      for (unsigned w = 1; w <= worker_.parts; ++w) shares_.counts[w] += shares_.counts[w - 1];
      const std::size_t all_rows = shares_.rows + shares_.counts[worker_.parts];
      shares_.copies.resize(shares_.counts[worker_.parts]);
      scratch_.solver_bodies.resize(all_rows);
      scratch_.visits.moved.resize(all_rows);
    }
    worker_.meet();
    std::uint32_t at = shares_.counts[worker_.part];
    for (auto i = static_cast<BodyIndex>(rows.begin); i < rows.end; ++i) {
      shares_.copies_before[i] = at;
      for (std::uint32_t k = copies_of(shares_.users[i]); k > 0; --k) shares_.copies[at++] = i;
    }
  }

  // Names this worker's rows in its batches, finds who else adds up their outcomes, and puts the batches first for
  // which others wait.
  void name_rows() {
    for (std::uint32_t layer = 0; layer < layers(); ++layer) {
      std::uint64_t& heirs = shares_.heirs[at(layer)] = 0;
      std::uint32_t* const begin = shares_.order.data() + shares_.first[at(layer)];
      std::uint32_t* const end = shares_.order.data() + shares_.first[at(layer) + 1];
      std::uint32_t* urgent = begin;
      places_.clear();  // of the others
      for (const std::uint32_t* k = begin; k != end; ++k) {
        const std::uint64_t others = name_rows_of(*k);
        heirs |= others;
        if (others != 0) {
          *urgent++ = *k;
        } else {
          places_.emplace_back(0, *k);
        }
      }
      shares_.urgent[at(layer)] = static_cast<std::uint32_t>(urgent - begin);
      for (const auto& place : places_) *urgent++ = place.second;
    }
  }
  // Returns the other workers who use bodies of the batch.
  std::uint64_t name_rows_of(std::uint32_t k) {
    std::uint64_t others = 0;
    for_sides(k, [&](std::uint32_t& row) {
      const std::uint64_t more = shares_.users[row] & ~(std::uint64_t{1} << worker_.part);
      if (more != 0) row = row_for(shares_, row, worker_.part);
      others |= more;
    });
    return others;
  }
  [[nodiscard]] std::size_t at(std::uint32_t layer) const { return std::size_t{layer} * worker_.parts + worker_.part; }

  // Lists for each worker the bodies of a layer that it uses in any layer, with the rows that it uses.
  void list_touched() {
    const unsigned parts = worker_.parts;
    for (auto layer = static_cast<std::uint32_t>(own_.begin); layer < own_.end; ++layer) {
      std::uint32_t count = 0;
      for (const BodyOutcomes& of : touched_of(layer)) count += copies_of(shares_.users[of.body]) + 1;
      shares_.touched_first[std::size_t{layer} * parts] = count;
    }
    worker_.meet();
    if (worker_.first()) {
      std::uint32_t sum = 0;
      for (std::uint32_t layer = 0; layer < layers(); ++layer) {
        sum += std::exchange(shares_.touched_first[std::size_t{layer} * parts], sum);
      }
      shares_.touched_first.back() = sum;
      shares_.touched.resize(sum);
    }
    worker_.meet();
    for (auto layer = static_cast<std::uint32_t>(own_.begin); layer < own_.end; ++layer) {
      std::array<std::uint32_t, kSharesMost + 1> next{};
      for_users(layer, [&](const BodyOutcomes&, unsigned w) { ++next[w + 1]; });
      next[0] = shares_.touched_first[std::size_t{layer} * parts];
      for (unsigned w = 1; w <= parts; ++w) next[w] += next[w - 1];
      for (unsigned w = 1; w < parts; ++w) shares_.touched_first[std::size_t{layer} * parts + w] = next[w];
      for_users(layer, [&](const BodyOutcomes& of, unsigned w) {
        shares_.touched[next[w]++] = {row_for(shares_, of.body, w), of.begin, of.end};
      });
    }
  }
  [[nodiscard]] std::span<const BodyOutcomes> touched_of(std::uint32_t layer) const {
    return std::span<const BodyOutcomes>(all_.touched)
        .subspan(all_.touched_start[layer], all_.touched_end[layer] - all_.touched_start[layer]);
  }
  template <class Visit>
  void for_users(std::uint32_t layer, Visit visit) const {
    for (const BodyOutcomes& of : touched_of(layer)) {
      for (std::uint64_t users = shares_.users[of.body]; users != 0; users &= users - 1) {
        visit(of, static_cast<unsigned>(std::countr_zero(users)));
      }
    }
  }

  const Bodies& bodies_;
  Scratch& scratch_;
  ContactBatches& all_;
  SweepShares& shares_;
  Worker worker_;
  int axis_;
  Worker::Share own_;  // layers
  std::vector<std::pair<double, std::uint32_t>>& places_;
};

void copy_body(Scratch& scratch, std::size_t k) {
  const SweepShares& shares = scratch.shares;
  scratch.solver_bodies[shares.rows + k] = scratch.solver_bodies[shares.copies[k]];
  scratch.visits.moved[shares.rows + k] = scratch.visits.moved[shares.copies[k]];
}

}  // namespace

void share_sweeps(const WorldState& state, Scratch& scratch) {
  SweepShares& shares = scratch.shares;
  ContactBatches& all = scratch.contact_batches;
  shares.copies.clear();
  shares.parts = 1;
  if (scratch.layers != nullptr) return;  // whoever looks at layers wants the rows of bodies
  shares.parts = std::min(kSharesMost, part_count(scratch.workers, all.batches.size(), kSweepBatches));
  if (shares.parts == 1) return;
  const std::size_t n = state.bodies.size(), pieces = all.touched_start.size() * shares.parts;
  shares.rows = static_cast<std::uint32_t>(n + 1);
  shares.order.resize(all.batches.size());
  shares.first.resize(pieces + 1);
  shares.first.back() = static_cast<std::uint32_t>(all.batches.size());
  shares.users.resize(n);
  shares.copies_before.resize(n);
  shares.counts.assign(shares.parts + 1, 0);
  shares.heirs.resize(pieces);
  shares.urgent.resize(pieces);
  shares.touched_first.resize(pieces + 1);
  make_outcomes(scratch, all.batches.size());  // workers are not all in one layer
  if (shares.places.size() < shares.parts) shares.places.resize(shares.parts);
  const int axis = axis_to_cut(state.bodies, all);
  work_together(scratch.workers, shares.parts,
                [&](const Worker& worker) { SharesBuilder(state, scratch, worker, axis).build(); });
}

void renew_copies(Scratch& scratch, const Worker& worker) {
  const Worker::Share share = worker.share(scratch.shares.copies.size());
  for (std::size_t k = share.begin; k < share.end; ++k) copy_body(scratch, k);
}

void renew_copies(Scratch& scratch) {
  for_ranges(scratch.workers, scratch.shares.copies.size(), kBodiesAPart, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) copy_body(scratch, k);
  });
}

}  // namespace tumble::sim
