#include "src/layered/solve/sweep_layers.h"

#include <algorithm>
#include <span>
#include <vector>

#include "src/base/check.h"
#include "src/kernels/kernels_by_width.h"
#include "src/layered/batch/share_sweeps.h"
#include "src/layered/islands/sweep_counts.h"
#include "src/layered/solve/contact_batches.h"
#include "src/layered/solve/fast_bodies.h"
#include "src/layered/solve/sweeper.h"

namespace tumble::sim {
namespace {

constexpr int kStopSweepsMax = 8;  // as many as a push has at most, but for tall towers
constexpr int kFastVisits = 4;     // of the contacts of fast pairs after a sweep; impacts have one substep to be solved
constexpr int kFirstFastVisits = 8;  // in the first turn of a bounce; in the others one, like those of layers
constexpr int kPushTurns = 4;        // cubes that fall as one overlap by 0.02 mm then; by 0.1 with two, by 18 with none

Direction opposite(Direction direction) { return direction == Direction::kUp ? Direction::kDown : Direction::kUp; }

// Calls task(sweeper) for so many workers that share the sweeps.
template <class Task>
void sweep_by(Scratch& scratch, unsigned parts, Task task) {
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

template <class Task>
void sweep_together(Scratch& scratch, Task task) {
  sweep_by(scratch, scratch.shares.parts, task);
}

// Sweep number k over the groups that take_part(group), in direction `first` or, if k is odd, in the opposite one.
// False: no body moves, of any worker.
template <class TakePart>
bool sweep_groups(const Scratch& scratch, Sweeper& sweeper, const ContactWork& all, Sweep sweep, int k, Direction first,
                  TakePart take_part) {
  bool moved = false;
  for (const SweepGroup& group : scratch.sweep_groups) {
    if (take_part(group)) moved |= sweeper.sweep_once(all, group, sweep, k % 2 == 0 ? first : opposite(first));
  }
  return sweeper.meet(moved);
}

// Takes the bodies of contacts that bounce for moved by the last visit, and no others: what is solved next is due to
// their motion alone, and not to what happens elsewhere. takes_part(manifold): whether a contact counts. False: nothing
// bounces.
template <class TakesPart>
bool stir_bouncing(Scratch& scratch, const ContactBatches& all, std::span<const Manifold> manifolds,
                   TakesPart takes_part) {
  std::vector<std::uint32_t>& moved = scratch.visits.moved;
  if (all.impacts.empty()) return false;
  std::ranges::fill(moved, 0U);
  bool any = false;
  const auto stir = [&](BodyIndex i) {
    if (i == kGround || scratch.solver_bodies[i].inverse_mass == 0) return;
    moved[i] = scratch.visits.now;
    any = true;
  };
  for (const ImpactBatch& impact : all.impacts) {
    const ContactBatch& batch = all.batches[impact.batch];
    for (unsigned lane = 0; lane < batch.used; ++lane) {
      if ((batch.bounces >> lane & 1U) == 0 || all.sides[impact.batch].visited[lane] == kNeverDue) continue;
      const Manifold& m = manifolds[all.order[batch.members + lane]];
      if (!takes_part(m)) continue;
      stir(m.a);
      stir(m.b);
    }
  }
  return any;
}

bool stir_bouncing(Scratch& scratch, const ContactBatches& all, std::span<const Manifold> manifolds) {
  return stir_bouncing(scratch, all, manifolds, [](const Manifold& /*all*/) { return true; });
}

bool presses(const ContactBatches& all, const ContactBatch& batch, unsigned lane) {
  const auto points = std::span(all.points).subspan(batch.first, batch.count);
  return std::ranges::any_of(points, [&](const PointBatch& point) { return point.impulse.of[lane] > 0; });
}

// Leaves out the contacts of fast pairs that restitution will make bounce and that press nothing yet: to hold them
// would stop them without a bounce. They are found again in the next substep.
void leave_out_later(ContactBatches& fast) {
  for (std::size_t k = 0; k < fast.batches.size(); ++k) {
    const ContactBatch& batch = fast.batches[k];
    for (unsigned lane = 0; lane < batch.used; ++lane) {
      const bool later = (batch.bounces >> lane & 1U) == 0 && batch.restitution.of[lane] > 0;
      if (later && !presses(fast, batch, lane)) fast.sides[k].visited[lane] = kNeverDue;
    }
  }
}

// Leaves out the contacts of layers that nothing has pressed in this step and that do not touch at its end: what ends
// the push would stop them in the air, and they would bounce there.
void leave_out_untouched(Scratch& scratch) {
  ContactBatches& all = scratch.contact_batches;
  for_shared_batches(scratch, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const ContactBatch& batch = all.batches[k];
      const auto points = std::span(all.points).subspan(batch.first, batch.count);
      for (unsigned lane = 0; lane < batch.used; ++lane) {
        const bool touches = std::ranges::any_of(points, [&](const PointBatch& point) {
          return point.peak.of[lane] > 0 || (point.mass.of[lane] > 0 && point.separation.of[lane] <= kSkin);
        });
        if (!touches) all.sides[k].visited[lane] = kNeverDue;
      }
    }
  });
}

// The impacts of layers and of fast pairs, as one.
class Impacts {
 public:
  Impacts(Scratch& scratch, double substep_s)
      : layers_(all_contacts(scratch, substep_s)),
        fast_(fast_contacts(scratch, substep_s)),
        of_layers_(scratch.contact_batches.impacts.size()),
        of_fast_(scratch.fast.none() ? 0 : scratch.fast.batches.impacts.size()) {}

  void begin_layers(Sweeper& sweeper, bool has_impulses = true) const {
    sweeper.begin_impacts(layers_, of_layers_, has_impulses);
  }
  void begin_fast(Sweeper& sweeper, bool has_impulses = true) const {
    sweeper.begin_impacts(fast_, of_fast_, has_impulses);
  }
  void end_layers(Sweeper& sweeper) const { sweeper.end_impacts(layers_, of_layers_); }
  void end_fast(Sweeper& sweeper) const { sweeper.end_whole_impacts(fast_, of_fast_); }

 private:
  ContactWork layers_, fast_;
  std::size_t of_layers_, of_fast_;
};

// Points without restitution that met fast are solved to the end, as far as sweeps go.
void stop_layers(Scratch& scratch, const ContactWork& all, const Impacts& impacts) {
  sweep_together(scratch, [&](Sweeper& sweeper) {
    impacts.begin_layers(sweeper);
    sweeper.begin();
    bool moved = true;
    for (int k = 0; moved && k < kStopSweepsMax; ++k) {
      sweeper.begin_sweep(k);
      moved = sweep_groups(scratch, sweeper, all, Sweep::kStop, k, Direction::kUp,
                           [&](const SweepGroup& group) { return k < (group.hard ? 1 : group.sweeps); });
    }
  });
}

// Whether bodies of fast pairs touch anything else.
bool fast_touch_layers(const Scratch& scratch) {
  return std::ranges::any_of(scratch.fast.bodies,
                             [&](const FastBody& of) { return scratch.in_contact[of.row] == kInContact; });
}

// Solves the contacts of fast pairs and the layers that these touch by turns, which in a push throw out what is light
// in hard islands. Hold ends the push of an impact.
void take_turns(Scratch& scratch, Sweep sweep, int turns, double substep_s) {
  const bool touches = fast_touch_layers(scratch);
  const ContactWork all = all_contacts(scratch, substep_s);
  const Impacts impacts(scratch, substep_s);
  const unsigned alone = part_count(scratch.workers, scratch.fast.batches.batches.size(), kBatchesAPart);
  sweep_by(scratch, touches || scratch.layers != nullptr ? scratch.shares.parts : alone, [&](Sweeper& sweeper) {
    if (sweep == Sweep::kRestitution) impacts.begin_fast(sweeper);
    if (touches) impacts.begin_layers(sweeper);
    bool moved = true;
    for (int turn = 0; moved && turn < turns; ++turn) {
      sweeper.begin_turn(turn);
      moved = sweeper.visit_fast_layer(sweep, substep_s, turn == 0 ? kFirstFastVisits : 1);
      if (!touches) continue;
      moved |= sweep_groups(scratch, sweeper, all, Sweep::kHold, turn, Direction::kUp,
                            [&](const SweepGroup& group) { return !group.hard || sweep != Sweep::kPush; });
    }
    if (sweep == Sweep::kHold) impacts.end_fast(sweeper);
    if (touches) impacts.end_layers(sweeper);
  });
}

}  // namespace

void warm_start_layers(Scratch& scratch, double substep_s) {
  const auto warm_start = [&](const ContactWork& work) {
    kernels(scratch.lanes).contacts.warm_start(work);
    return Due::kAll;
  };
  const ContactWork all = all_contacts(scratch, substep_s);
  const Impacts impacts(scratch, substep_s);
  sweep_together(scratch, [&](Sweeper& sweeper) {
    impacts.begin_layers(sweeper, false);
    impacts.begin_fast(sweeper, false);
    for (std::uint32_t layer = 0; layer + 1 < scratch.layer_start.size(); ++layer) {
      sweeper.solve_layer(all, layer, Due::kAll, warm_start);
    }
    sweeper.meet(false);
    if (!scratch.fast.none()) sweeper.solve_fast(substep_s, warm_start);
  });
}

void sweep_layers(Scratch& scratch, Sweep sweep, Direction first, double substep_s) {
  const ContactWork all = all_contacts(scratch, substep_s);
  const Impacts impacts(scratch, substep_s);
  const int fast_visits = scratch.fast.none() ? 0 : kFastVisits;
  int most = 0;
  for (const SweepGroup& group : scratch.sweep_groups) most = std::max(most, group.sweeps);
  sweep_together(scratch, [&](Sweeper& sweeper) {
    if (sweep == Sweep::kHold) impacts.begin_layers(sweeper);  // bodies have turned since the push
    sweeper.begin();
    bool moved = true;
    for (int k = 0; moved && k < most; ++k) {
      sweeper.begin_sweep(k);
      moved = sweep_groups(scratch, sweeper, all, Sweep::kHold, k, first,
                           [&](const SweepGroup& group) { return k < group.sweeps; });
      if (fast_visits > 0) moved |= sweeper.visit_fast_layer(sweep, substep_s, fast_visits);
    }
    impacts.end_layers(sweeper);
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

bool bounce_fast_layer(const Bodies& bodies, Scratch& scratch, double substep_s) {
  ContactBatches& fast = scratch.fast.batches;
  const std::span<const Manifold> manifolds = scratch.fast.found.manifolds;
  if (!stir_bouncing(scratch, fast, manifolds)) return false;
  leave_out_later(fast);
  take_turns(scratch, Sweep::kHold, kBounceTurnsMax, substep_s);  // the push has to be over
  take_back_gifts(bodies, scratch);
  stir_bouncing(scratch, fast, manifolds);
  take_turns(scratch, Sweep::kRestitution, kBounceTurnsMax, substep_s);
  return fast_touch_layers(scratch);
}

void end_fast_push(Scratch& scratch, double substep_s) {
  const auto held = [&](BodyIndex i) { return i != kGround && scratch.in_contact[i] == kInContact; };
  const auto touches_layers = [&](const Manifold& m) { return held(m.a) || held(m.b); };
  const FastContacts& fast = scratch.fast;
  if (fast.none() || !stir_bouncing(scratch, fast.batches, fast.found.manifolds, touches_layers)) return;
  take_turns(scratch, Sweep::kPush, kPushTurns, substep_s);
}

void bounce_layers(Scratch& scratch, double dt_s) {
  const ContactWork all = all_contacts(scratch, dt_s);
  const Impacts impacts(scratch, dt_s);
  if (scratch.contact_batches.impacts.empty()) return;
  leave_out_untouched(scratch);
  stop_layers(scratch, all, impacts);
  for (const Sweep sweep : {Sweep::kHold, Sweep::kRestitution}) {
    if (!stir_bouncing(scratch, scratch.contact_batches, scratch.manifolds)) return;
    sweep_together(scratch, [&](Sweeper& sweeper) {
      impacts.begin_layers(sweeper);
      bool moved = true;
      for (int turn = 0; moved && turn < kBounceTurnsMax; ++turn) {
        sweeper.begin_turn(turn);
        moved = sweep_groups(scratch, sweeper, all, sweep, turn, Direction::kUp, [](auto& /*all*/) { return true; });
      }
      if (sweep == Sweep::kHold) impacts.end_layers(sweeper);
    });
  }
}

}  // namespace tumble::sim
