#include "tumble/sim/step.h"

#include <bit>
#include <cmath>
#include <iterator>
#include <span>
#include <string>
#include <string_view>

#include "src/layered/find/find_manifolds.h"
#include "src/layered/find/find_near_pairs.h"
#include "src/layered/order/assign_levels.h"
#include "src/layered/order/carry_weights.h"
#include "src/layered/order/update_sleeping.h"
#include "src/layered/order/wake_islands.h"
#include "src/layered/solve/apply_forces.h"
#include "src/layered/solve/bounce_contacts.h"
#include "src/layered/solve/bounce_fast_contacts.h"
#include "src/layered/solve/find_fast_contacts.h"
#include "src/layered/solve/finish_motion.h"
#include "src/layered/solve/integrate_positions.h"
#include "src/layered/solve/part_overlaps.h"
#include "src/layered/solve/prepare_manifolds.h"
#include "src/layered/solve/push_contacts.h"
#include "src/layered/solve/relax_contacts.h"
#include "src/thesis/apply_outcomes.h"
#include "src/thesis/compute_impulses.h"
#include "src/thesis/compute_separation.h"
#include "src/thesis/find_contacts.h"
#include "src/thesis/find_pairs.h"
#include "src/thesis/find_planes.h"
#include "src/thesis/integrate.h"
#include "src/thesis/recheck_planes.h"
#include "src/thesis/update_freezing.h"
#include "src/world/for_bodies.h"
#include "src/world/free_flight.h"
#include "src/world/scratch.h"

namespace tumble::sim {
namespace {

// The place of a phase in its table. A name that is not there does not compile.
consteval std::size_t place_of(std::span<const Phase> phases, std::string_view name) {
  std::size_t place = 0;
  while (phases[place].name != name) ++place;
  return place;
}

// Chapter III of the thesis, in order. Each phase has a file of its name.
constexpr Phase kThesisPhases[] = {
    {"integrate", integrate, hash_integrate},
    {"find_pairs", find_pairs, hash_find_pairs},
    {"find_planes", find_planes, hash_find_planes},
    // --- here a substep with too many collisions is undone and halved ---
    {"find_contacts", find_contacts, hash_find_contacts},
    {"compute_impulses", compute_impulses, hash_compute_impulses},
    {"compute_separation", compute_separation, hash_compute_separation},
    {"apply_outcomes", apply_outcomes, hash_apply_outcomes},
    {"recheck_planes", recheck_planes, hash_recheck_planes},
    {"update_freezing", update_freezing, hash_update_freezing},
};
constexpr PhaseTable kThesis = {kThesisPhases, 0, std::size(kThesisPhases), place_of(kThesisPhases, "find_contacts")};

// Contacts are found once a step; gravity, contacts and motion alternate in substeps.
constexpr Phase kLayeredPhases[] = {
    {"find_near_pairs", find_near_pairs, hash_find_near_pairs},
    {"find_manifolds", find_manifolds, hash_find_manifolds},
    {"wake_islands", wake_islands, hash_wake_islands},
    {"assign_levels", assign_levels, hash_assign_levels},
    {"carry_weights", carry_weights, hash_carry_weights},
    {"prepare_manifolds", prepare_manifolds, hash_prepare_manifolds},
    {"part_overlaps", part_overlaps, hash_part_overlaps},
    // --- in every substep ---
    {"find_fast_contacts", find_fast_contacts, hash_find_fast_contacts},
    {"apply_forces", apply_forces, hash_apply_forces},
    {"push_contacts", push_contacts, hash_push_contacts},
    {"integrate_positions", integrate_positions, hash_integrate_positions},
    {"relax_contacts", relax_contacts, hash_relax_contacts},
    {"bounce_fast_contacts", bounce_fast_contacts, hash_bounce_fast_contacts},
    // --- once a step ---
    {"bounce_contacts", bounce_contacts, hash_bounce_contacts},
    {"finish_motion", finish_motion, hash_finish_motion},
    {"update_sleeping", update_sleeping, hash_update_sleeping},
};
constexpr PhaseTable kLayered = {kLayeredPhases, place_of(kLayeredPhases, "find_fast_contacts"),
                                 place_of(kLayeredPhases, "bounce_contacts"), 0};

// floor(log2(substeps)): the number of times that a step may be halved.
unsigned recursion_depth(const WorldDef& def) { return static_cast<unsigned>(std::bit_width(def.substeps)) - 1U; }

// Steps without a moving body, after which further steps change nothing: the first such step may still drop contacts of
// bodies that have come to rest apart, so one step is not enough.
constexpr std::uint32_t kStillSteps = 2;

bool nothing_moves(const Bodies& bodies) {
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    if (bodies.moves(i)) return false;
  }
  return true;
}

// Method layered: the number of points of the manifolds that were solved; those of fast pairs come last.
std::uint32_t solved_points(const Scratch& scratch) {
  const auto& links = scratch.graph.links;
  std::uint32_t count = 0;
  for (std::size_t k = links.size(); k < scratch.manifolds.size(); ++k) count += scratch.manifolds[k].count;
  for_manifolds(scratch, links.size(), [&](std::size_t begin, std::size_t end) {
    std::uint32_t here = 0;
    for (std::size_t k = begin; k < end; ++k) here += links[k].awake ? links[k].count : 0U;
    shared::add(count, here);
  });
  return count;
}

// total_energy(), whose terms several workers compute; they are added in the order of rows, since this sum is rounded.
Energy energy_at_end(const WorldState& state, Scratch& scratch) {
  const std::size_t n = state.bodies.size();
  if (part_count(scratch.workers, n, kBodiesAPart) == 1) return total_energy(state);
  scratch.energies.resize(n);
  for_bodies(scratch, n, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) scratch.energies[i] = energy_of(state, i);
  });
  Energy energy;
  for (const Energy& of : scratch.energies) {
    energy = {energy.kinetic + of.kinetic, energy.potential + of.potential};
  }
  return energy;
}

// Whether more than `most` bodies fall into the ground within dt_s; the trial phases would find that too, but later.
bool grounds_more_than(std::size_t most, const WorldState& state, double dt_s) {
  const Bodies& bodies = state.bodies;
  const double fall = falling_reach(state.def, dt_s);
  std::size_t found = 0;
  for (BodyIndex i = 0; state.def.ground && i < bodies.size() && found <= most; ++i) {
    const Vec3 half_extent = bodies.half_extent[i];
    const double lowest = bodies.position.z[i] - ((half_extent.x() + half_extent.y()) + half_extent.z());  // a bound
    if (!bodies.moves(i) || lowest > std::fabs(bodies.velocity.z[i]) * dt_s + fall) continue;
    const Flight flight = free_flight(state, i, dt_s);
    if (reaches_ground({flight.position, axes_of(flight.orientation), half_extent})) ++found;
  }
  return found > most;
}

// One call of step(): runs the substeps and counts.
class StepRun {
 public:
  StepRun(World& world, Observer* observer)
      : world_(world), observer_(observer), table_(phase_table(world.state().def.method)) {}

  Status run_all() {
    const WorldDef& def = world_.state().def;
    if (Status ok = run_range(0, table_.substeps_begin, def.dt); !ok.ok()) return ok;
    if (table_.trial_count > 0) {
      world_.mutable_scratch().framed.assign(world_.bodies().size(), 0);
      if (Status ok = advance(def.dt, recursion_depth(def)); !ok.ok()) return ok;
      world_.mutable_scratch().framed.clear();
    } else {
      for (std::uint32_t k = 0; k < def.substeps; ++k) {
        if (Status ok = accept(def.dt / def.substeps); !ok.ok()) return ok;
      }
    }
    --substep_;  // the phases that follow count to the last substep
    return run_range(table_.substeps_end, table_.phases.size(), def.dt);
  }

  /// The calls of run_all() to the observer without running a phase, for a world without moving bodies: every phase
  /// would write the values that the scratch holds already.
  void look_at_all() {
    const std::uint32_t substeps = world_.state().def.substeps;
    world_.mutable_scratch().fed_hasher = nullptr;
    for (std::size_t k = 0; k < table_.substeps_begin; ++k) notify(k);
    for (; substep_ < substeps; ++substep_) {
      for (std::size_t k = table_.substeps_begin; k < table_.substeps_end; ++k) notify(k);
    }
    counters_.substeps = substep_--;
    for (std::size_t k = table_.substeps_end; k < table_.phases.size(); ++k) notify(k);
  }

  [[nodiscard]] StepCounters counters() const { return counters_; }

 private:
  /// Advances by dt_s, halving as often as `depth` allows when there are too many collisions (thesis V.A).
  Status advance(double dt_s, unsigned depth) {
    const std::size_t most = world_.state().def.split_collisions;
    const bool may_halve = depth > 0;
    // Counting the bodies that fall into the ground is cheap and usually saves the trial.
    if (may_halve && grounds_more_than(most, world_.state(), dt_s)) return halve(dt_s, depth);
    if (may_halve) save(depth);
    for (std::size_t k = 0; k < table_.trial_count; ++k) {
      if (Status ok = run(k, dt_s); !ok.ok()) return ok;
    }
    if (may_halve && world_.scratch().contacts.size() > most) {
      put_back(depth);
      return halve(dt_s, depth);
    }
    return accept(dt_s);
  }

  Status halve(double dt_s, unsigned depth) {
    if (Status ok = advance(dt_s / 2, depth - 1); !ok.ok()) return ok;
    return advance(dt_s / 2, depth - 1);
  }

  Status run_range(std::size_t begin, std::size_t end, double dt_s) {
    for (std::size_t k = begin; k < end; ++k) {
      if (Status ok = run(k, dt_s); !ok.ok()) return ok;
      notify(k);
    }
    return {};
  }

  Status run(std::size_t phase, double dt_s) {
    Scratch& scratch = world_.mutable_scratch();
    const bool alone = scratch.workers == nullptr || scratch.workers->count() == 1;
    const bool tried = phase - table_.substeps_begin < table_.trial_count;
    scratch.hasher = observer_ != nullptr && alone && !tried ? observer_->phase_begins() : nullptr;
    scratch.fed_hasher = nullptr;
    Status status = table_.phases[phase].run(world_.mutable_state(), scratch, dt_s);
    scratch.hasher = nullptr;
    if (status.ok()) return status;
    return Error{status.error().kind, "step " + std::to_string(world_.state().step + 1) + ", phase " +
                                          table_.phases[phase].name + ": " + status.error().message};
  }

  // Observers see only accepted substeps. The scratch still holds the values that the trial phases wrote.
  Status accept(double dt_s) {
    const std::size_t tried = table_.substeps_begin + table_.trial_count;
    for (std::size_t k = table_.substeps_begin; k < tried; ++k) notify(k);
    if (Status ok = run_range(tried, table_.substeps_end, dt_s); !ok.ok()) return ok;
    counters_.contacts += static_cast<std::uint32_t>(world_.scratch().contacts.size());
    counters_.substeps = ++substep_;
    return {};
  }

  void notify(std::size_t phase) {
    if (observer_ != nullptr) observer_->phase_done(substep_, phase, world_);
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
  std::uint32_t substep_ = 0;
};

}  // namespace

PhaseTable phase_table(Method method) { return method == Method::kThesis ? kThesis : kLayered; }

Result<StepCounters> step(World& world, Observer* observer) {
  world.mutable_scratch().removed_energy = 0;
  StepRun run(world, observer);
  std::uint32_t& still = world.mutable_scratch().still_steps;
  const bool may_be_still = world.state().def.method == Method::kLayered;
  still = may_be_still && nothing_moves(world.bodies()) ? still + 1 : 0;
  if (still > kStillSteps) {
    run.look_at_all();
  } else if (Status ok = run.run_all(); !ok.ok()) {
    return ok.error();
  }
  ++world.mutable_state().step;

  StepCounters counters = run.counters();
  if (world.state().def.method == Method::kLayered) counters.contacts = solved_points(world.scratch());
  const Energy energy = energy_at_end(world.state(), world.mutable_scratch());
  counters.pairs = static_cast<std::uint32_t>(world.state().pairs.size());
  counters.kinetic = energy.kinetic;
  counters.potential = energy.potential;
  counters.inputs = world.input_energy();
  counters.removed = world.scratch().removed_energy;
  world.forget_input_energy();
  return counters;
}

}  // namespace tumble::sim
