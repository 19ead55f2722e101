#include "golden/hunt/judge/trace.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "src/base/check.h"
#include "src/world/scratch.h"

namespace tumble::hunt {
namespace {

using sim::BodyIndex;
using sim::dot;
using sim::length;
using sim::Vec3;

sim::BodyId id_of(const sim::World& world, BodyIndex row) {
  return row == sim::kGround ? kGroundId : world.bodies().id[row];
}

Meeting meeting_of(const sim::World& world, BodyIndex a, BodyIndex b) {
  const sim::BodyId first = id_of(world, a), second = id_of(world, b);
  return {std::min(first, second), std::max(first, second)};
}

/// Hashes phases, and keeps who met and with which force.
class Watch : public sim::Observer {
 public:
  Watch(sim::Method method, TracedStep& step) : step_(step) {
    const sim::PhaseTable table = phase_table(method);
    for (std::size_t k = 0; k < table.phases.size(); ++k) {
      const std::string_view name = table.phases[k].name;
      if (name == "compute_impulses") thesis_contacts_ = k;
      if (name == "find_fast_contacts") layered_pairs_ = k;
    }
  }

  void phase_done(std::uint32_t substep, std::size_t phase, const sim::World& world) override {
    hashes_.phase_done(substep, phase, world);
    if (phase == thesis_contacts_) see_thesis(world);
    if (phase == layered_pairs_) see_layered(world);
  }

  void finish() {
    step_.words = hashes_.words();
    std::sort(step_.met.begin(), step_.met.end());
    step_.met.erase(std::unique(step_.met.begin(), step_.met.end()), step_.met.end());
  }

 private:
  void see_thesis(const sim::World& world) {
    const sim::Contacts& contacts = world.scratch().contacts;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      step_.met.push_back(meeting_of(world, contacts.a[k], contacts.b[k]));
      const Vec3 impulse = contacts.impulse[k], n = contacts.normal[k];
      const double along = dot(impulse, n);
      step_.forces.push_back({id_of(world, contacts.a[k]), id_of(world, contacts.b[k]), std::fabs(along),
                              length(impulse - n * along), contacts.depth[k]});
    }
  }

  void see_layered(const sim::World& world) {
    const sim::Scratch& scratch = world.scratch();
    for (const sim::Manifold& m : scratch.manifolds) step_.met.push_back(meeting_of(world, m.a, m.b));
    for (const sim::ContactPair& pair : scratch.fast.pairs) {
      step_.met.push_back(meeting_of(world, pair.first, pair.second));
    }
    step_.fast_pairs |= !scratch.fast.none();
    step_.hard_islands |= std::ranges::any_of(scratch.sweep_groups, &sim::SweepGroup::hard);
    step_.lent_inertia |= std::ranges::any_of(scratch.lent_along, [](const Vec3& along) { return length(along) > 0; });
    step_.parted |= scratch.overlaps_part;
  }

  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  TracedStep& step_;
  sim::PhaseHashes hashes_;
  std::size_t thesis_contacts_ = kNone, layered_pairs_ = kNone;
};

// The state with inputs that the session accepted.
std::optional<sim::WorldState> begun_with(const sim::WorldState& before, const std::vector<sim::Command>& inputs) {
  if (inputs.empty()) return std::nullopt;
  Result<sim::World> world = sim::World::restore(before);
  SIM_CHECK(world.ok());
  for (const sim::Command& input : inputs) SIM_CHECK(sim::apply(*world, input).ok());
  return world->state();
}

}  // namespace

Result<Trace> trace(const sim::SceneDef& scene) {
  Trace out;
  out.scene = scene;
  out.again = trace;
  Result<replay::Session> session = replay::Session::start(scene);
  if (!session.ok()) return session.error();
  out.states.push_back(session->world().state());
  while (session->steps_done() < scene.steps) {
    TracedStep step;
    Watch watch(scene.world.method, step);
    const Result<replay::TakenStep> taken = session->step({}, &watch);
    if (!taken.ok() && taken.error().kind == ErrorKind::kBadInput) return taken.error();
    if (!taken.ok()) {
      out.failure = taken.error().message;
      return out;
    }
    watch.finish();
    step.dt = taken->dt;
    step.inputs.assign(taken->inputs.begin(), taken->inputs.end());
    step.counters = taken->counters;
    step.begun = begun_with(out.states.back(), step.inputs);
    out.states.push_back(session->world().state());
    out.steps.push_back(std::move(step));
  }
  return out;
}

}  // namespace tumble::hunt
