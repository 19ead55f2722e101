#include "src/solve/sweep_layers.h"

#include <algorithm>

#include "src/solve/contact_batches.h"

namespace tumble::sim {
namespace {

constexpr int kLevelsPerSweep = 5;  // measured: columns of 8 that sway after a fall come to rest with two, not with one
constexpr int kSweepsMax = 10;

constexpr std::size_t kWorthBatches = 512;  // for a thread more; measured
constexpr std::size_t kWorthBodies = 8192;

// Lets the manifolds of a layer find what they do, then the bodies take it up.
template <class Solve>
void solve_layer(Scratch& scratch, std::size_t layer, double substep_s, Solve solve) {
  const ContactBatches& all = scratch.contact_batches;
  const ContactWork work = contacts_of_layer(scratch, layer, substep_s);
  for_ranges(scratch.workers, work.count, kWorthBatches,
             [&](std::size_t begin, std::size_t end) { solve(part_of(work, begin, end)); });
  const BodyOutcomes* touched = all.touched.data() + all.touched_start[layer];
  const std::size_t count = all.touched_start[layer + 1] - all.touched_start[layer];
  const ContactKernels& kernels = contact_kernels(scratch.lanes);
  for_ranges(scratch.workers, count, kWorthBodies,
             [&](std::size_t begin, std::size_t end) { kernels.apply_outcomes(work, touched + begin, end - begin); });
}

}  // namespace

void warm_start_layers(World& world, double substep_s) {
  Scratch& scratch = world.mutable_scratch();
  const ContactKernels& kernels = contact_kernels(scratch.lanes);
  for (std::size_t layer = 0; layer + 1 < scratch.layer_start.size(); ++layer) {
    solve_layer(scratch, layer, substep_s, kernels.warm_start);
  }
}

void sweep_layers(World& world, Sweep sweep, Direction direction, double substep_s) {
  Scratch& scratch = world.mutable_scratch();
  const ContactKernels& kernels = contact_kernels(scratch.lanes);
  const std::size_t layers = scratch.layer_start.size() - 1;
  for (std::size_t k = 0; k < layers; ++k) {
    const std::size_t layer = direction == Direction::kUp ? k : layers - 1 - k;
    solve_layer(scratch, layer, substep_s, [&](const ContactWork& work) { kernels.solve(work, sweep); });
  }
}

int sweep_count(const Scratch& scratch) {
  const int levels = static_cast<int>(scratch.layer_start.size() - 2) / 2;
  return std::min(kSweepsMax, 1 + levels / kLevelsPerSweep);
}

}  // namespace tumble::sim
