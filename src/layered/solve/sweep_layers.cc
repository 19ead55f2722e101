#include "src/layered/solve/sweep_layers.h"

#include <algorithm>

#include "src/base/check.h"
#include "src/kernels/kernels_by_width.h"
#include "src/layered/solve/contact_batches.h"

namespace tumble::sim {
namespace {

constexpr std::size_t kSweepBatches = 512;  // that pay for one more worker; measured
constexpr std::size_t kSweepBodies = 8192;

constexpr int kFastVisits = 4;  // of the contacts of fast pairs after a sweep; impacts have one substep to be solved

// Solves the manifolds of a layer, then adds the outcomes to the bodies.
template <class Solve>
void solve_layer(const Scratch& scratch, const ContactKernels& kernels, const ContactBatches& all, std::size_t layer,
                 const ContactWork& work, Solve solve) {
  const BodyOutcomes* touched = all.touched.data() + all.touched_start[layer];
  const std::size_t count = all.touched_start[layer + 1] - all.touched_start[layer];
  if (scratch.workers == nullptr) {  // a tower has as many layers as bodies: each call counts
    solve(work);
    kernels.apply_outcomes(work, touched, count);
    return;
  }
  for_ranges(scratch.workers, work.count, kSweepBatches,
             [&](std::size_t begin, std::size_t end) { solve(part_of(work, begin, end)); });
  for_ranges(scratch.workers, count, kSweepBodies,
             [&](std::size_t begin, std::size_t end) { kernels.apply_outcomes(work, touched + begin, end - begin); });
}

Direction opposite(Direction direction) { return direction == Direction::kUp ? Direction::kDown : Direction::kUp; }

// all: the contacts of all layers.
void sweep_once(Scratch& scratch, const ContactWork& all, const SweepGroup& group, Sweep sweep, Direction direction) {
  const ContactKernels& contacts = kernels(scratch.lanes).contacts;
  for (std::uint32_t k = group.begin; k < group.end; ++k) {
    const std::uint32_t layer = direction == Direction::kUp ? k : group.end - 1 - (k - group.begin);
    solve_layer(scratch, contacts, scratch.contact_batches, layer, contacts_of_layer(scratch, all, layer),
                [&](const ContactWork& work) { contacts.solve(work, sweep); });
  }
}

}  // namespace

void warm_start_layers(Scratch& scratch, double substep_s) {
  const ContactKernels& contacts = kernels(scratch.lanes).contacts;
  for (std::size_t layer = 0; layer + 1 < scratch.layer_start.size(); ++layer) {
    solve_layer(scratch, contacts, scratch.contact_batches, layer,
                contacts_of_layer(scratch, all_contacts(scratch, substep_s), layer), contacts.warm_start);
  }
  if (scratch.fast.none()) return;
  solve_layer(scratch, contacts, scratch.fast.batches, 0, fast_contacts(scratch, substep_s), contacts.warm_start);
}

void sweep_layers(Scratch& scratch, Sweep sweep, Direction first, double substep_s) {
  const ContactWork all = all_contacts(scratch, substep_s);
  const Sweep layered = sweep == Sweep::kPush ? Sweep::kHold : sweep;  // part_overlaps has pushed these
  int most = 0;
  for (const SweepGroup& group : scratch.sweep_groups) {
    most = std::max(most, sweep == Sweep::kRestitution ? 1 : group.sweeps);
  }
  for (int k = 0; k < most; ++k) {
    for (const SweepGroup& group : scratch.sweep_groups) {
      if (k >= (sweep == Sweep::kRestitution ? 1 : group.sweeps)) continue;
      sweep_once(scratch, all, group, layered, k % 2 == 0 ? first : opposite(first));
    }
    if (sweep == Sweep::kRestitution) continue;
    for (int visit = 0; visit < kFastVisits; ++visit) solve_fast_layer(scratch, sweep, substep_s);
  }
}

void sweep_overlaps(Scratch& scratch, const ContactWork& all, int more) {
  for (const SweepGroup& group : scratch.sweep_groups) {
    for (int k = 0; k < group.sweeps + more; ++k) {
      sweep_once(scratch, all, group, Sweep::kPart, k % 2 == 0 ? Direction::kDown : Direction::kUp);
    }
  }
}

void solve_fast_layer(Scratch& scratch, Sweep sweep, double substep_s) {
  if (scratch.fast.none()) return;
  const ContactKernels& contacts = kernels(scratch.lanes).contacts;
  solve_layer(scratch, contacts, scratch.fast.batches, 0, fast_contacts(scratch, substep_s),
              [&](const ContactWork& work) { contacts.solve(work, sweep); });
}

bool has_hard(const Scratch& scratch) {
  SIM_CHECK(!scratch.sweep_groups.empty());
  return scratch.sweep_groups.back().hard;
}

}  // namespace tumble::sim
