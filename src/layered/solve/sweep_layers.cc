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

// Solves the manifolds of a layer that are due, then adds the outcomes to the bodies. False: none was due.
// solve(work): whether any was.
template <class Solve>
bool solve_layer(Scratch& scratch, const ContactBatches& all, std::size_t layer, ContactWork work, Solve solve) {
  const ContactKernels& contacts = kernels(scratch.lanes).contacts;
  VisitScratch& visits = scratch.visits;
  work.visit = {visits.moved.data(), ++visits.now, visits.first, visits.still};
  const BodyOutcomes* touched = all.touched.data() + all.touched_start[layer];
  const std::size_t count = all.touched_start[layer + 1] - all.touched_start[layer];
  if (scratch.workers == nullptr) {  // a tower has as many layers as bodies: each call counts
    if (!solve(work)) return false;
    if (scratch.layers != nullptr) [[unlikely]]
      scratch.layers->layer_solved(scratch, all, layer);
    contacts.apply_outcomes(work, touched, count);
    return true;
  }
  if (work.count == 0) return false;
  visits.due.assign(work.count, 0);
  for_ranges(scratch.workers, work.count, kSweepBatches, [&](std::size_t begin, std::size_t end) {
    visits.due[begin] = static_cast<std::uint8_t>(solve(part_of(work, begin, end)));
  });
  if (std::find(visits.due.begin(), visits.due.end(), 1) == visits.due.end()) return false;
  if (scratch.layers != nullptr) [[unlikely]]
    scratch.layers->layer_solved(scratch, all, layer);
  for_ranges(scratch.workers, count, kSweepBodies,
             [&](std::size_t begin, std::size_t end) { contacts.apply_outcomes(work, touched + begin, end - begin); });
  return true;
}

// Makes all contacts due.
void begin_sweeps(Scratch& scratch) { scratch.visits.first = ++scratch.visits.now; }

Direction opposite(Direction direction) { return direction == Direction::kUp ? Direction::kDown : Direction::kUp; }

// Whether anything was due. all: the contacts of all layers.
bool sweep_once(Scratch& scratch, const ContactWork& all, const SweepGroup& group, Sweep sweep, Direction direction) {
  const ContactKernels& contacts = kernels(scratch.lanes).contacts;
  bool due = false;
  for (std::uint32_t k = group.begin; k < group.end; ++k) {
    const std::uint32_t layer = direction == Direction::kUp ? k : group.end - 1 - (k - group.begin);
    due |= solve_layer(scratch, scratch.contact_batches, layer, contacts_of_layer(scratch, all, layer),
                       [&](const ContactWork& work) { return contacts.solve(work, sweep); });
  }
  return due;
}

bool visit_fast_layer(Scratch& scratch, Sweep sweep, double substep_s) {
  const ContactKernels& contacts = kernels(scratch.lanes).contacts;
  return solve_layer(scratch, scratch.fast.batches, 0, fast_contacts(scratch, substep_s),
                     [&](const ContactWork& work) { return contacts.solve(work, sweep); });
}

int sweeps_of(const SweepGroup& group, Sweep sweep) { return sweep == Sweep::kRestitution ? 1 : group.sweeps; }

}  // namespace

void warm_start_layers(Scratch& scratch, double substep_s) {
  const auto warm_start = [&](const ContactWork& work) {
    kernels(scratch.lanes).contacts.warm_start(work);
    return true;
  };
  const ContactWork all = all_contacts(scratch, substep_s);
  for (std::size_t layer = 0; layer + 1 < scratch.layer_start.size(); ++layer) {
    solve_layer(scratch, scratch.contact_batches, layer, contacts_of_layer(scratch, all, layer), warm_start);
  }
  if (scratch.fast.none()) return;
  solve_layer(scratch, scratch.fast.batches, 0, fast_contacts(scratch, substep_s), warm_start);
}

void sweep_layers(Scratch& scratch, Sweep sweep, Direction first, double substep_s) {
  const ContactWork all = all_contacts(scratch, substep_s);
  const Sweep layered = sweep == Sweep::kPush ? Sweep::kHold : sweep;  // part_overlaps has pushed these
  const int fast_visits = sweep == Sweep::kRestitution || scratch.fast.none() ? 0 : kFastVisits;
  int most = 0;
  for (const SweepGroup& group : scratch.sweep_groups) most = std::max(most, sweeps_of(group, sweep));
  begin_sweeps(scratch);
  bool due = true;
  for (int k = 0; due && k < most; ++k) {
    due = false;
    for (const SweepGroup& group : scratch.sweep_groups) {
      if (k >= sweeps_of(group, sweep)) continue;
      due |= sweep_once(scratch, all, group, layered, k % 2 == 0 ? first : opposite(first));
    }
    for (int visit = 0; visit < fast_visits; ++visit) due |= visit_fast_layer(scratch, sweep, substep_s);
  }
}

double find_overlaps(Scratch& scratch, const ContactWork& all) {
  begin_sweeps(scratch);
  ContactWork work = all;
  work.visit.first = scratch.visits.first;
  return kernels(scratch.lanes).contacts.find_overlaps(work);
}

void sweep_overlaps(Scratch& scratch, const ContactWork& all, int more) {
  for (const SweepGroup& group : scratch.sweep_groups) {
    bool due = true;
    for (int k = 0; due && k < group.sweeps + more; ++k) {
      due = sweep_once(scratch, all, group, Sweep::kPart, k % 2 == 0 ? Direction::kDown : Direction::kUp);
    }
  }
}

void solve_fast_layer(Scratch& scratch, Sweep sweep, double substep_s, int visits) {
  if (scratch.fast.none()) return;
  begin_sweeps(scratch);
  for (int k = 0; k < visits; ++k) {
    if (!visit_fast_layer(scratch, sweep, substep_s)) return;
  }
}

bool has_hard(const Scratch& scratch) {
  SIM_CHECK(!scratch.sweep_groups.empty());
  return scratch.sweep_groups.back().hard;
}

}  // namespace tumble::sim
