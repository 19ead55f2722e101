#include "src/layered/solve/sweep_layers.h"

#include <algorithm>
#include <span>
#include <vector>

#include "src/base/check.h"
#include "src/kernels/kernels_by_width.h"
#include "src/layered/solve/contact_batches.h"
#include "src/layered/solve/sweeper.h"

namespace tumble::sim {
namespace {

constexpr int kBounceSweepsMax = 8;
constexpr int kFastVisits = 4;  // of the contacts of fast pairs after a sweep; impacts have one substep to be solved

Direction opposite(Direction direction) { return direction == Direction::kUp ? Direction::kDown : Direction::kUp; }

// A bounce takes as many sweeps as its push, but for tall towers; and one in hard islands, where many would throw out
// what is light between heavy bodies.
int sweeps_of(const SweepGroup& group, Sweep sweep) {
  if (sweep != Sweep::kRestitution) return group.sweeps;
  return group.hard ? 1 : std::min(kBounceSweepsMax, group.sweeps);
}

// Calls task(sweeper) for all workers that share the sweeps.
template <class Task>
void sweep_together(Scratch& scratch, Task task) {
  const unsigned parts = scratch.shares.parts;
  const std::uint32_t now = scratch.visits.now;
  std::vector<std::vector<VisitScratch::Layer>>& layers = scratch.visits.layers;
  if (layers.size() < parts) layers.resize(parts);
  constexpr std::size_t kLines = 128 / sizeof(VisitScratch::Layer);  // behind the last layer, which nobody writes
  for (unsigned part = 0; part < parts; ++part) {
    layers[part].resize(scratch.visits.reach.size() + kLines);
    layers[part].resize(scratch.visits.reach.size());
  }
  work_together(scratch.workers, parts, [&](const Worker& worker) {
    renew_copies(scratch, worker);
    worker.meet();
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
    for (std::uint32_t layer = 0; layer + 1 < scratch.layer_start.size(); ++layer) {
      sweeper.solve_layer(all, layer, Due::kAll, warm_start);
    }
    sweeper.meet(false);
    if (!scratch.fast.none()) sweeper.solve_fast(substep_s, warm_start);
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
      sweeper.begin_sweep(k);
      for (const SweepGroup& group : scratch.sweep_groups) {
        if (k >= sweeps_of(group, sweep)) continue;
        moved |= sweeper.sweep_once(all, group, layered, k % 2 == 0 ? first : opposite(first));
      }
      moved = sweeper.meet(moved);
      if (fast_visits > 0) moved |= sweeper.visit_fast_layer(sweep, substep_s, fast_visits);
    }
  });
}

double find_overlaps(Scratch& scratch, const ContactWork& all) {
  scratch.visits.first = ++scratch.visits.now;
  ContactWork work = all;
  work.visit.first = scratch.visits.first;
  double deepest = 0;
  for_shared_batches(scratch, [&](std::size_t begin, std::size_t end) {
    shared::raise(deepest, kernels(scratch.lanes).contacts.find_overlaps(part_of(work, begin, end)));
  });
  return deepest;
}

void sweep_overlaps(Scratch& scratch, const ContactWork& all, int more) {
  sweep_together(scratch, [&](Sweeper& sweeper) {
    sweeper.go_on();
    for (const SweepGroup& group : scratch.sweep_groups) {
      bool moved = true;
      for (int k = 0; moved && k < group.sweeps + more; ++k) {
        sweeper.begin_sweep(k);
        moved =
            sweeper.meet(sweeper.sweep_once(all, group, Sweep::kPart, k % 2 == 0 ? Direction::kDown : Direction::kUp));
      }
    }
  });
}

void solve_fast_layer(Scratch& scratch, Sweep sweep, double substep_s, int visits) {
  if (scratch.fast.none()) return;
  const std::uint32_t now = scratch.visits.now;
  const std::size_t batches = scratch.fast.batches.batches.size();
  const unsigned parts = scratch.layers != nullptr ? 1 : part_count(scratch.workers, batches, kBatchesAPart);
  work_together(scratch.workers, parts, [&](const Worker& worker) {
    Sweeper sweeper(scratch, worker, now, {});
    sweeper.begin();
    sweeper.visit_fast_layer(sweep, substep_s, visits);
    sweeper.finish();
  });
}

}  // namespace tumble::sim
