#include "src/layered/batch/share_sweeps.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "src/layered/batch/cut_layers.h"

namespace tumble::sim {
namespace {

// Bodies, of which one may be with another worker than before: a line that travels costs less than all workers waiting
// until one has settled the bodies anew.
constexpr std::size_t kSettled = 32;

// What one of the workers does to share the sweeps.
class SharesBuilder {
 public:
  SharesBuilder(const WorldState& state, Scratch& scratch, const Worker& worker)
      : bodies_(state.bodies),
        scratch_(scratch),
        all_(scratch.contact_batches),
        shares_(scratch.shares),
        worker_(worker),
        axis_(scratch.shares.axis),
        own_(worker.share_groups(all_.layer_start)),
        places_(scratch.shares.places[worker.part]) {}

  void build() {
    const Worker::Share rows = worker_.share(bodies_.size());
    std::fill(shares_.users.begin() + static_cast<std::ptrdiff_t>(rows.begin),
              shares_.users.begin() + static_cast<std::ptrdiff_t>(rows.end), std::uint64_t{0});
    worker_.meet();
    find_users();
    worker_.meet();
    find_homes(rows);
    place_copies(rows);
    worker_.meet();
    name_rows();
    renew_copies(scratch_, worker_);
    list_touched();
  }

 private:
  [[nodiscard]] std::uint32_t layers() const { return static_cast<std::uint32_t>(all_.touched_start.size()); }

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

  // Where a body is at home: with the first of its users; without contact, where they cut the largest layer.
  [[nodiscard]] std::uint8_t home_of(std::size_t i) const {
    const std::uint64_t users = shares_.users[i];
    if (users != 0) return static_cast<std::uint8_t>(std::countr_zero(users));
    const auto cuts = shares_.cuts.begin(), end = cuts + (worker_.parts - 1);
    return static_cast<std::uint8_t>(std::upper_bound(cuts, end, 2 * bodies_.position[i][axis_]) - cuts);
  }
  // Settles the bodies anew where many of a worker's range have moved.
  void find_homes(const Worker::Share& rows) {
    Homes& homes = scratch_.homes;
    const std::size_t n = bodies_.size();
    const bool known = homes.were_told(n, worker_.parts);
    std::size_t moved = 0;
    for (std::size_t i = rows.begin; known && i < rows.end; ++i) moved += home_of(i) != homes.worker_of(i) ? 1U : 0U;
    if (!worker_.meet(!known || moved * kSettled > rows.end - rows.begin)) return;
    if (worker_.first()) homes.begin(n);
    worker_.meet();
    for (std::size_t i = rows.begin; i < rows.end; ++i) homes.tell(i, home_of(i));
    worker_.meet();
    if (worker_.first()) homes.settle_told(worker_.parts, *scratch_.workers);
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
  OwnList<std::pair<double, std::uint32_t>>& places_;
};

void copy_body(Scratch& scratch, std::size_t k) {
  const SweepShares& shares = scratch.shares;
  scratch.solver_bodies[shares.rows + k] = scratch.solver_bodies[shares.copies[k]];
  scratch.visits.moved[shares.rows + k] = scratch.visits.moved[shares.copies[k]];
}

}  // namespace

void share_sweeps(const WorldState& state, Scratch& scratch) {
  if (scratch.shares.parts == 1) return;
  work_together(scratch.workers, scratch.shares.parts,
                [&](const Worker& worker) { SharesBuilder(state, scratch, worker).build(); });
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
