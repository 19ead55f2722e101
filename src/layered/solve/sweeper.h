#pragma once

#include <algorithm>
#include <bit>
#include <span>

#include "src/kernels/kernels_by_width.h"
#include "src/layered/batch/share_sweeps.h"
#include "src/layered/solve/contact_batches.h"

namespace tumble::sim {

/// What one of several workers does in sweeps. All visit the same layers in the same order, but each solves its own
/// batches (SweepShares) and adds outcomes to its own rows of bodies. It waits only for workers whose batches in that
/// layer give outcomes to one of its bodies; all meet at the end of a sweep.
class Sweeper {
 public:
  // now: the number of the last visit. layers: notes of the layers that it sweeps.
  Sweeper(Scratch& scratch, const Worker& worker, std::uint32_t now, std::span<VisitScratch::Layer> layers)
      : scratch_(scratch), contacts_(kernels(scratch.lanes).contacts), worker_(worker), layers_(layers), now_(now) {
    std::ranges::fill(layers_, VisitScratch::Layer{});
  }

  // Makes all contacts due.
  void begin() { first_ = ++now_; }
  // Takes those as solved that find_overlaps has marked.
  void go_on() { first_ = scratch_.visits.first; }
  // What is solved next belongs to the sweep of this number, from 0 on.
  void begin_sweep(int number) { sweep_ = static_cast<std::uint32_t>(number); }
  // The same of a bounce's turns.
  void begin_turn(int number) {
    begin_sweep(number);
    bounces_ = true;
  }
  // Notes the number of the last visit.
  void finish() const {
    if (worker_.first()) scratch_.visits.now = now_;
  }

  // Solves the manifolds of a layer; false: no body has moved. solve(work): how many were due. unknown: how many of
  // another worker's where its word has been overwritten by its next one: kSome, but kAll where `solve` notes no
  // visits.
  template <class Solve>
  bool solve_layer(const ContactWork& all, std::uint32_t layer, Due unknown, Solve solve) {
    if (worker_.parts > 1) return solve_own(all, layer, unknown, solve);
    const bool moved = solve_alone(scratch_.contact_batches, layer, contacts_of_layer(scratch_, all, layer), solve);
    layers_[layer].looked = now_;
    if (moved) stir(scratch_.visits.reach[layer]);
    return moved;
  }

  // Visits the layers of which a body may have moved since the last visit: nothing is due in the others. False: no body
  // of this worker's has moved. all: the contacts of all layers.
  bool sweep_once(const ContactWork& all, const SweepGroup& group, Sweep sweep, Direction direction) {
    bool any_moved = false;
    for (std::uint32_t k = group.begin; k < group.end; ++k) {
      const std::uint32_t layer = direction == Direction::kUp ? k : group.end - 1 - (k - group.begin);
      if (worker_.parts == 1 && rests(layer)) continue;
      any_moved |=
          solve_layer(all, layer, Due::kSome, [&](const ContactWork& work) { return contacts_.solve(work, sweep); });
    }
    return any_moved;
  }

  // Solves the contacts of fast pairs, `visits` times at most. False: no body has moved.
  bool visit_fast_layer(Sweep sweep, double substep_s, int visits) {
    bool any_moved = false, moved = true;
    for (int visit = 0; moved && visit < visits; ++visit) {
      moved = solve_fast(substep_s, [&](const ContactWork& work) { return contacts_.solve(work, sweep); });
      if (moved) all_stirred_ = now_;  // fast pairs are few
      any_moved |= moved;
    }
    if (worker_.parts > 1) {
      renew_copies(scratch_, worker_);
      worker_.meet();
    }
    return any_moved;
  }

  // Solves the contacts of fast pairs. False: no body has moved. The bodies have their first rows here.
  template <class Solve>
  bool solve_fast(double substep_s, Solve solve) {
    const ContactBatches& all = scratch_.fast.batches;
    ContactWork work = fast_contacts(scratch_, substep_s);
    if (worker_.parts == 1) return solve_alone(all, 0, work, solve);
    if (!start(work)) return false;
    const Worker::Share batches = worker_.share(work.count);
    const Worker::Share bodies = worker_.share(all.touched_end[0] - all.touched_start[0]);
    const bool due = batches.begin < batches.end && solve(part_of(work, batches.begin, batches.end)) != Due::kNone;
    if (!worker_.meet(due)) return false;
    return worker_.meet(contacts_.apply_outcomes(work, all.touched.data() + all.touched_start[0] + bodies.begin,
                                                 bodies.end - bodies.begin, Due::kAll));
  }

  // Before sweeps: notes what the `impacts` of `all` have got. has_impulses: what a substep begins with is among it.
  void begin_impacts(const ContactWork& all, std::size_t impacts, bool has_impulses) {
    const Worker::Share share = worker_.share(impacts);
    contacts_.begin_impacts(all, share.begin, share.end, has_impulses);
    if (worker_.parts > 1 && impacts > 0) worker_.meet();
  }
  void end_whole_impacts(const ContactWork& all, std::size_t impacts) {
    const Worker::Share share = worker_.share(impacts);
    contacts_.end_whole_impacts(all, share.begin, share.end);
  }
  // After sweeps, when all workers have met: adds what they have taken meanwhile.
  void end_impacts(const ContactWork& all, std::size_t impacts) {
    const Worker::Share share = worker_.share(impacts);
    contacts_.end_impacts(all, share.begin, share.end);
  }

  // Whether one of the workers passed true.
  bool meet(bool any) const { return worker_.meet(any); }

 private:
  // What a worker posts of a visit: its number, and how many of its manifolds were due.
  static constexpr unsigned kDueBits = 2;
  static std::uint32_t post_of(std::uint32_t visit, Due due) {
    return visit << kDueBits | static_cast<std::uint32_t>(due);
  }

  [[nodiscard]] bool rests(std::uint32_t layer) const {
    const VisitScratch::Layer& last = layers_[layer];
    return last.looked != 0 && std::max(last.stirred, all_stirred_) < last.looked;
  }

  // A tower has as many layers as bodies: each call counts.
  template <class Solve>
  bool solve_alone(const ContactBatches& all, std::uint32_t layer, ContactWork work, Solve solve) {
    if (!start(work)) return false;
    work.leaves_old = scratch_.layers == nullptr;
    const Due due = solve(work);
    bool moved = false;
    if (due != Due::kNone) {
      tell_solved(all, layer);
      moved = contacts_.apply_outcomes(work, all.touched.data() + all.touched_start[layer],
                                       all.touched_end[layer] - all.touched_start[layer], due);
    }
    return moved;
  }
  // Whether there is anything to solve.
  bool start(ContactWork& work) {
    work.visit = {scratch_.visits.moved.data(), ++now_, first_, sweep_, bounces_, scratch_.visits.still};
    return work.count != 0;
  }

  template <class Solve>
  bool solve_own(const ContactWork& all, std::uint32_t layer, Due unknown, Solve solve) {
    ContactWork work = contacts_of_layer(scratch_, all, layer);
    if (!start(work)) return false;
    const SweepShares& shares = scratch_.shares;
    const std::uint32_t begin = scratch_.contact_batches.layer_start[layer];
    work.outcomes += std::size_t{begin} * kLanes * 2 * kOutcomeDoubles;
    work.leaves_old = true;
    bool all_due = true, any_due = false;
    const auto add = [&](Due due) {
      all_due &= due == Due::kAll;
      any_due |= due != Due::kNone;
    };
    const std::size_t piece = std::size_t{layer} * worker_.parts;
    const std::span<const std::uint32_t> own = shares.batches_of(layer, worker_.part);
    const bool rest = rests(layer);
    const auto solve_some = [&](std::span<const std::uint32_t> some) {
      if (rest && !some.empty()) return add(Due::kNone);
      for_runs(some,
               [&](std::uint32_t from, std::uint32_t to) { add(solve(part_of(work, from - begin, to - begin))); });
    };
    // What others wait for comes first, so that it travels while the rest is solved.
    const std::uint64_t* const heirs = &shares.heirs[piece];
    const std::uint32_t urgent = shares.urgent[piece + worker_.part];
    solve_some(own.first(urgent));
    if (heirs[worker_.part] != 0) {
      worker_.post(post_of(now_, !any_due ? Due::kNone : all_due ? Due::kAll : Due::kSome));
    }
    solve_some(own.subspan(urgent));
    if (!rest) layers_[layer].looked = now_;
    for (unsigned other = 0; other < worker_.parts; ++other) {
      if ((heirs[other] >> worker_.part & 1U) == 0) continue;
      const std::uint32_t post = worker_.await(other, post_of(now_, Due::kNone));
      // It may have posted a later visit since.
      add(post >> kDueBits == now_ ? static_cast<Due>(post & ((1U << kDueBits) - 1)) : unknown);
    }
    const std::span<const BodyOutcomes> touched = shares.touched_of(layer, worker_.part);
    if (!any_due || touched.empty()) return false;
    const bool moved = contacts_.apply_outcomes(work, touched.data(), touched.size(), all_due ? Due::kAll : Due::kSome);
    if (moved) stir(scratch_.visits.reach[layer]);
    return moved;
  }

  void stir(const VisitScratch::Reach& reach) {
    if (reach.end - reach.begin == layers_.size()) {
      all_stirred_ = now_;
      return;
    }
    for (std::uint32_t layer = reach.begin; layer < reach.end; ++layer) layers_[layer].stirred = now_;
  }
  // The outcomes are there, and no body has got any.
  void tell_solved(const ContactBatches& all, std::size_t layer) const {
    if (scratch_.layers != nullptr) [[unlikely]]
      scratch_.layers->layer_solved(scratch_, all, layer);
  }

  Scratch& scratch_;
  const ContactKernels& contacts_;
  Worker worker_;
  std::span<VisitScratch::Layer> layers_;
  std::uint32_t now_, first_ = 0, sweep_ = 0;
  bool bounces_ = false;
  std::uint32_t all_stirred_ = 0;  // as VisitScratch::Layer::stirred, for all layers
};

}  // namespace tumble::sim
