#include "src/step/step.h"

#include <bit>
#include <string>

#include "src/collide/find_contacts.h"
#include "src/collide/find_pairs.h"
#include "src/collide/find_planes.h"
#include "src/collide/recheck_planes.h"
#include "src/solve/apply_outcomes.h"
#include "src/solve/compute_impulses.h"
#include "src/solve/compute_separation.h"
#include "src/solve/integrate.h"
#include "src/solve/update_freezing.h"

namespace tumble::sim {
namespace {

// The thesis's chapter III, in the order it runs. Each phase is the file of its name.
constexpr Phase kThesisPhases[] = {
    {"integrate", integrate, hash_integrate},
    {"find_pairs", find_pairs, hash_find_pairs},
    {"find_planes", find_planes, hash_find_planes},
    // --- a sub-step that met too many collisions is taken back and halved here ---
    {"find_contacts", find_contacts, hash_find_contacts},
    {"compute_impulses", compute_impulses, hash_compute_impulses},
    {"compute_separation", compute_separation, hash_compute_separation},
    {"apply_outcomes", apply_outcomes, hash_apply_outcomes},
    {"recheck_planes", recheck_planes, hash_recheck_planes},
    {"update_freezing", update_freezing, hash_update_freezing},
};
constexpr std::size_t kThesisTrialPhases = 3;

// One call of step(): the sub-steps of a step, counted.
class SubstepRun {
 public:
  SubstepRun(World& world, Observer* observer)
      : world_(world), observer_(observer), table_(phase_table(world.state().def.method)) {}

  /// Advances by dt_s, halving as often as `depth` allows when there are too many collisions (thesis V.A).
  Status advance(double dt_s, unsigned depth) {
    if (depth > 0) save(depth);
    for (std::size_t k = 0; k < table_.trial_count; ++k) {
      if (Status ok = run(k, dt_s); !ok.ok()) return ok;
    }
    if (depth > 0 && world_.scratch().contacts.a.size() > world_.state().def.split_collisions) {
      put_back(depth);
      if (Status ok = advance(dt_s / 2, depth - 1); !ok.ok()) return ok;
      return advance(dt_s / 2, depth - 1);
    }
    return accept(dt_s);
  }

  [[nodiscard]] StepCounters counters() const { return counters_; }

 private:
  Status run(std::size_t phase, double dt_s) {
    Status status = table_.phases[phase].run(world_, dt_s);
    if (status.ok()) return status;
    return Error{status.error().kind, "step " + std::to_string(world_.state().step + 1) + ", phase " +
                                          table_.phases[phase].name + ": " + status.error().message};
  }

  // Only accepted sub-steps are seen. What the trial phases wrote is still there to be looked at.
  Status accept(double dt_s) {
    for (std::size_t k = 0; k < table_.trial_count; ++k) notify(k);
    for (std::size_t k = table_.trial_count; k < table_.phases.size(); ++k) {
      if (Status ok = run(k, dt_s); !ok.ok()) return ok;
      notify(k);
    }
    counters_.contacts += static_cast<std::uint32_t>(world_.scratch().contacts.size());
    ++counters_.substeps;
    return {};
  }

  void notify(std::size_t phase) {
    if (observer_ != nullptr) observer_->phase_done(counters_.substeps, phase, world_);
  }

  SavedMotion& saved(unsigned depth) {
    std::vector<SavedMotion>& all = world_.mutable_scratch().saved;
    if (all.size() < depth) all.resize(depth);
    return all[depth - 1];
  }
  void save(unsigned depth) {
    const WorldState& state = world_.state();
    SavedMotion& to = saved(depth);
    to.position = state.bodies.position;
    to.orientation = state.bodies.orientation;
    to.velocity = state.bodies.velocity;
    to.spin = state.bodies.spin;
    to.pairs = state.pairs;
  }
  void put_back(unsigned depth) {
    WorldState& state = world_.mutable_state();
    const SavedMotion& from = saved(depth);
    state.bodies.position = from.position;
    state.bodies.orientation = from.orientation;
    state.bodies.velocity = from.velocity;
    state.bodies.spin = from.spin;
    state.pairs = from.pairs;
  }

  World& world_;
  Observer* observer_;
  PhaseTable table_;
  StepCounters counters_;
};

// floor(log2(substeps)): how often a step may be halved.
unsigned recursion_depth(const WorldDef& def) { return static_cast<unsigned>(std::bit_width(def.substeps)) - 1U; }

}  // namespace

PhaseTable phase_table(Method /*method*/) { return {kThesisPhases, kThesisTrialPhases}; }

Result<StepCounters> step(World& world, Observer* observer) {
  const WorldDef& def = world.state().def;
  world.mutable_scratch().removed_energy = 0;
  SubstepRun run(world, observer);
  if (Status ok = run.advance(def.dt, recursion_depth(def)); !ok.ok()) return ok.error();
  ++world.mutable_state().step;

  StepCounters counters = run.counters();
  const Energy energy = total_energy(world.state());
  counters.pairs = static_cast<std::uint32_t>(world.state().pairs.size());
  counters.kinetic = energy.kinetic;
  counters.potential = energy.potential;
  counters.inputs = world.input_energy();
  counters.removed = world.scratch().removed_energy;
  world.forget_input_energy();
  return counters;
}

}  // namespace tumble::sim
