#include "tumble/replay/session.h"

#include <string>
#include <utility>

#include "src/world/scratch.h"

namespace tumble::replay {

Session::Session(sim::SceneDef scene, sim::World world) : scene_(std::move(scene)), world_(std::move(world)) {}

Result<Session> Session::start(sim::SceneDef scene) {
  Result<sim::World> world = sim::create_world(scene);
  if (!world.ok()) return world.error();
  return Session(std::move(scene), *std::move(world));
}

Result<Session> Session::resume(sim::WorldState state, sim::SceneDef scene) {
  Result<sim::World> world = sim::World::restore(std::move(state));
  if (!world.ok()) return world.error();
  return Session(std::move(scene), *std::move(world));
}

void Session::use(sim::LaneWidth lanes) { world_.mutable_scratch().lanes = lanes; }

// Order decides bits: a push before a throw meets another world than one after it. The scene's inputs come first
// because their steps are fixed before the session begins; live ones follow in the order in which they were made. The
// comparison is `<=` and not `==`: an input for a step that has passed is applied late and does not block those behind.
Status Session::apply_inputs(std::span<const sim::Command> live) {
  const std::uint64_t step = world_.state().step + 1;
  applied_.clear();
  const std::vector<sim::TimedCommand>& inputs = scene_.inputs;
  while (next_input_ < inputs.size() && inputs[next_input_].step <= step) {
    applied_.push_back(inputs[next_input_++].command);
  }
  applied_.insert(applied_.end(), live.begin(), live.end());
  for (const sim::Command& command : applied_) {
    if (Status ok = sim::apply(world_, command); !ok.ok()) {
      return Error{ok.error().kind, "input \"" + std::string(sim::name_of(command)) + "\" before step " +
                                        std::to_string(step) + ": " + ok.error().message};
    }
  }
  return {};
}

Result<TakenStep> Session::step(std::span<const sim::Command> live, sim::Observer* observer) {
  if (Status ok = apply_inputs(live); !ok.ok()) return ok.error();
  const double dt = world_.state().def.dt;  // after the inputs, one of which may have set it
  const Result<sim::StepCounters> counters = sim::step(world_, observer);
  if (!counters.ok()) return counters.error();
  return TakenStep{dt, applied_, *counters};
}

}  // namespace tumble::replay
