#include "src/layered/solve/sweep_layers.h"

#include <algorithm>
#include <span>
#include <vector>

#include "src/base/check.h"
#include "src/kernels/kernels_by_width.h"
#include "src/layered/solve/contact_batches.h"

namespace tumble::sim {
namespace {

constexpr std::size_t kSweepBatches = 96;  // of all layers, that pay for one more worker
constexpr std::size_t kLayerBatches = 4;   // of one layer

constexpr int kFastVisits = 4;  // of the contacts of fast pairs after a sweep; impacts have one substep to be solved

Direction opposite(Direction direction) { return direction == Direction::kUp ? Direction::kDown : Direction::kUp; }

int sweeps_of(const SweepGroup& group, Sweep sweep) { return sweep == Sweep::kRestitution ? 1 : group.sweeps; }

// What one of several workers does in sweeps. All of them visit one layer after the other; of each they solve ranges of
// batches, meet, add the outcomes to ranges of bodies, and meet again.
class Sweeper {
 public:
  // now: the number of the last visit. layers: notes of the layers that it sweeps.
  Sweeper(Scratch& scratch, const Worker& worker, std::uint32_t now, std::span<VisitScratch::Layer> layers)
      : scratch_(scratch), contacts_(kernels(scratch.lanes).contacts), worker_(worker), layers_(layers), now_(now) {}

  // Makes all contacts due.
  void begin() {
    first_ = ++now_;
    std::ranges::fill(layers_, VisitScratch::Layer{});
  }
  // Takes those as solved that find_overlaps has marked.
  void go_on() {
    first_ = scratch_.visits.first;
    std::ranges::fill(layers_, VisitScratch::Layer{});
  }
  // Notes the number of the last visit.
  void finish() const {
    if (worker_.first()) scratch_.visits.now = now_;
  }

  // Solves the manifolds of a layer that are due, then adds the outcomes to the bodies. False: no body has moved.
  // solve(work): how many were due.
  template <class Solve>
  bool solve_layer(const ContactBatches& all, std::size_t layer, ContactWork work, Solve solve) {
    work.visit = {scratch_.visits.moved.data(), ++now_, first_, scratch_.visits.still};
    const BodyOutcomes* touched = all.touched.data() + all.touched_start[layer];
    const std::size_t count = all.touched_end[layer] - all.touched_start[layer];
    if (work.count == 0) return false;
    const unsigned workers = workers_for(work.count);
    if (workers == 1) {  // a tower has as many layers as bodies: each call counts
      work.leaves_old = scratch_.layers == nullptr;
      const Due due = worker_.first() ? solve(work) : Due::kNone;
      bool moved = false;
      if (due != Due::kNone) {
        tell_solved(all, layer);
        moved = contacts_.apply_outcomes(work, touched, count, due);
      }
      return worker_.meet(moved);
    }
    const Worker::Share batches = worker_.share(work.count, workers), bodies = worker_.share(count, workers);
    const bool due = batches.begin < batches.end && solve(part_of(work, batches.begin, batches.end)) != Due::kNone;
    if (!worker_.meet(due)) return false;
    if (scratch_.layers != nullptr) [[unlikely]] {
      if (worker_.first()) tell_solved(all, layer);
      worker_.meet();
    }
    return worker_.meet(contacts_.apply_outcomes(work, touched + bodies.begin, bodies.end - bodies.begin, Due::kAll));
  }

  // Visits the layers of which a body may have moved since the last visit: nothing is due in the others. False: no body
  // has moved, so nothing is due any more. all: the contacts of all layers.
  bool sweep_once(const ContactWork& all, const SweepGroup& group, Sweep sweep, Direction direction) {
    bool any_moved = false;
    for (std::uint32_t k = group.begin; k < group.end; ++k) {
      const std::uint32_t layer = direction == Direction::kUp ? k : group.end - 1 - (k - group.begin);
      const VisitScratch::Layer& last = layers_[layer];
      if (last.looked != 0 && std::max(last.stirred, all_stirred_) < last.looked) continue;
      const bool moved = solve_layer(scratch_.contact_batches, layer, contacts_of_layer(scratch_, all, layer),
                                     [&](const ContactWork& work) { return contacts_.solve(work, sweep); });
      layers_[layer].looked = now_;
      if (moved) stir(scratch_.visits.reach[layer]);
      any_moved |= moved;
    }
    return any_moved;
  }

  bool visit_fast_layer(Sweep sweep, double substep_s) {
    const bool moved = solve_layer(scratch_.fast.batches, 0, fast_contacts(scratch_, substep_s),
                                   [&](const ContactWork& work) { return contacts_.solve(work, sweep); });
    if (moved) all_stirred_ = now_;  // fast pairs are few
    return moved;
  }

 private:
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
  [[nodiscard]] unsigned workers_for(std::size_t batches) const {
    return worker_.parts == 1 ? 1 : std::min(worker_.parts, part_count(scratch_.workers, batches, kLayerBatches));
  }

  Scratch& scratch_;
  const ContactKernels& contacts_;
  Worker worker_;
  std::span<VisitScratch::Layer> layers_;
  std::uint32_t now_, first_ = 0;
  std::uint32_t all_stirred_ = 0;  // as VisitScratch::Layer::stirred, for all layers
};

// Calls task(sweeper) for as many workers as the contacts of all layers are worth.
template <class Task>
void sweep_together(Scratch& scratch, Task task) {
  const unsigned parts = part_count(scratch.workers, scratch.contact_batches.batches.size(), kSweepBatches);
  const std::uint32_t now = scratch.visits.now;
  std::vector<std::vector<VisitScratch::Layer>>& layers = scratch.visits.layers;
  if (layers.size() < parts) layers.resize(parts);
  for (unsigned part = 0; part < parts; ++part) layers[part].resize(scratch.visits.reach.size());
  work_together(scratch.workers, parts, [&](const Worker& worker) {
    Sweeper sweeper(scratch, worker, now, layers[worker.part]);
    task(sweeper);
    sweeper.finish();
  });
}

}  // namespace

void warm_start_layers(Scratch& scratch, double substep_s) {
  const auto warm_start = [&](const ContactWork& work) {
    kernels(scratch.lanes).contacts.warm_start(work);
    return Due::kAll;
  };
  const ContactWork all = all_contacts(scratch, substep_s);
  sweep_together(scratch, [&](Sweeper& sweeper) {
    for (std::size_t layer = 0; layer + 1 < scratch.layer_start.size(); ++layer) {
      sweeper.solve_layer(scratch.contact_batches, layer, contacts_of_layer(scratch, all, layer), warm_start);
    }
    if (scratch.fast.none()) return;
    sweeper.solve_layer(scratch.fast.batches, 0, fast_contacts(scratch, substep_s), warm_start);
  });
}

void sweep_layers(Scratch& scratch, Sweep sweep, Direction first, double substep_s) {
  const ContactWork all = all_contacts(scratch, substep_s);
  const Sweep layered = sweep == Sweep::kPush ? Sweep::kHold : sweep;  // part_overlaps has pushed these
  const int fast_visits = sweep == Sweep::kRestitution || scratch.fast.none() ? 0 : kFastVisits;
  int most = 0;
  for (const SweepGroup& group : scratch.sweep_groups) most = std::max(most, sweeps_of(group, sweep));
  sweep_together(scratch, [&](Sweeper& sweeper) {
    sweeper.begin();
    bool moved = true;
    for (int k = 0; moved && k < most; ++k) {
      moved = false;
      for (const SweepGroup& group : scratch.sweep_groups) {
        if (k >= sweeps_of(group, sweep)) continue;
        moved |= sweeper.sweep_once(all, group, layered, k % 2 == 0 ? first : opposite(first));
      }
      for (int visit = 0; visit < fast_visits; ++visit) moved |= sweeper.visit_fast_layer(sweep, substep_s);
    }
  });
}

double find_overlaps(Scratch& scratch, const ContactWork& all) {
  scratch.visits.first = ++scratch.visits.now;
  ContactWork work = all;
  work.visit.first = scratch.visits.first;
  double deepest = 0;
  const unsigned parts = part_count(scratch.workers, work.count, kBatchesAPart);
  work_together(scratch.workers, parts, [&](const Worker& worker) {
    const Worker::Share share = worker.share(work.count);
    worker.raise(deepest, kernels(scratch.lanes).contacts.find_overlaps(part_of(work, share.begin, share.end)));
  });
  return deepest;
}

void sweep_overlaps(Scratch& scratch, const ContactWork& all, int more) {
  sweep_together(scratch, [&](Sweeper& sweeper) {
    sweeper.go_on();
    for (const SweepGroup& group : scratch.sweep_groups) {
      bool moved = true;
      for (int k = 0; moved && k < group.sweeps + more; ++k) {
        moved = sweeper.sweep_once(all, group, Sweep::kPart, k % 2 == 0 ? Direction::kDown : Direction::kUp);
      }
    }
  });
}

void solve_fast_layer(Scratch& scratch, Sweep sweep, double substep_s, int visits) {
  if (scratch.fast.none()) return;
  Sweeper sweeper(scratch, Worker{}, scratch.visits.now, {});
  sweeper.begin();
  for (int k = 0; k < visits && sweeper.visit_fast_layer(sweep, substep_s); ++k) continue;
  sweeper.finish();
}

bool has_hard(const Scratch& scratch) {
  SIM_CHECK(!scratch.sweep_groups.empty());
  return scratch.sweep_groups.back().hard;
}

}  // namespace tumble::sim
