#include "replay/import/apply_as_told.h"

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "src/world/body_check.h"
#include "src/world/edit_bodies.h"
#include "tumble/sim/limits.h"
#include "tumble/sim/step.h"

namespace tumble::replay {
namespace {

/// The body of a push or a velocity whose numbers a log holds, whatever they would do to it in our world; else 0.
sim::BodyId moved_by(const sim::Command& command) {
  if (const auto* push = std::get_if<sim::Push>(&command)) {
    return sim::within(push->impulse, sim::kMassMax) && sim::within(push->at, sim::kPositionMax) ? push->id : 0;
  }
  const auto* set = std::get_if<sim::SetVelocity>(&command);
  if (set == nullptr) return 0;
  return sim::within(set->velocity, sim::kSpeedMax) && sim::within(set->spin, sim::kSpeedMax) ? set->id : 0;
}

}  // namespace

Status apply_as_told(sim::World& world, const sim::Command& command) {
  sim::WorldState& state = world.mutable_state();
  if (std::holds_alternative<sim::SetGravity>(command) || std::holds_alternative<sim::Throw>(command)) {
    std::vector<sim::BodyId> asleep;
    for (sim::BodyIndex i = 0; i < state.bodies.size(); ++i) {
      if (state.bodies.frozen[i] != 0) asleep.push_back(state.bodies.id[i]);
    }
    Status done = sim::apply(world, command);
    for (const sim::BodyId id : asleep) state.bodies.frozen[*state.bodies.find(id)] = 1;
    return done;
  }
  Status done = sim::apply(world, command);
  if (done.ok()) return done;
  const std::optional<sim::BodyIndex> row = state.bodies.find(moved_by(command));
  if (!row) return done;
  sim::wake_body(state, *row);
  return {};
}

}  // namespace tumble::replay
