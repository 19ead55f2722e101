#include "src/layered/solve/sweep_layers.h"

#include "src/base/check.h"
#include "src/kernels/kernels_by_width.h"
#include "src/layered/solve/contact_batches.h"

namespace tumble::sim {
namespace {

constexpr std::size_t kSweepBatches = 512;  // that pay for one more worker; measured
constexpr std::size_t kSweepBodies = 8192;

// Solves the manifolds of a layer, then adds the outcomes to the bodies.
template <class Solve>
void solve_layer(Scratch& scratch, const ContactKernels& kernels, std::size_t layer, double substep_s, Solve solve) {
  const ContactBatches& all = scratch.contact_batches;
  const ContactWork work = contacts_of_layer(scratch, layer, substep_s);
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

void sweep_once(Scratch& scratch, const SweepGroup& group, Sweep sweep, Direction direction, double substep_s) {
  const ContactKernels& contacts = kernels(scratch.lanes).contacts;
  for (std::uint32_t k = group.begin; k < group.end; ++k) {
    const std::uint32_t layer = direction == Direction::kUp ? k : group.end - 1 - (k - group.begin);
    solve_layer(scratch, contacts, layer, substep_s, [&](const ContactWork& work) { contacts.solve(work, sweep); });
  }
}

}  // namespace

void warm_start_layers(Scratch& scratch, double substep_s) {
  const ContactKernels& contacts = kernels(scratch.lanes).contacts;
  for (std::size_t layer = 0; layer + 1 < scratch.layer_start.size(); ++layer) {
    solve_layer(scratch, contacts, layer, substep_s, contacts.warm_start);
  }
}

void sweep_layers(Scratch& scratch, Sweep sweep, Direction first, double substep_s) {
  for (const SweepGroup& group : scratch.sweep_groups) {
    const int sweeps = sweep == Sweep::kRestitution ? 1 : group.sweeps;
    for (int k = 0; k < sweeps; ++k) sweep_once(scratch, group, sweep, k % 2 == 0 ? first : opposite(first), substep_s);
  }
}

bool has_slender(const Scratch& scratch) {
  SIM_CHECK(!scratch.sweep_groups.empty());
  return scratch.sweep_groups.back().slender;
}

}  // namespace tumble::sim
