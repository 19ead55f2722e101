#include "replay/live/live_inputs.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "tumble/sim/step.h"

namespace tumble::replay {
namespace {

sim::BodyId id_above(const Recorder& recorder) {
  sim::BodyId above = 0;
  const auto see = [&](sim::BodyId id) { above = std::max(above, id + 1); };
  for (const sim::BoxDef& box : recorder.scene().boxes) see(box.id);
  for (const sim::TimedCommand& input : recorder.scene().inputs) {
    if (const auto* thrown = std::get_if<sim::Throw>(&input.command)) see(thrown->box.id);
  }
  const std::vector<sim::BodyId>& ids = recorder.world().bodies().id;
  if (!ids.empty()) see(ids.back());
  return above;
}

}  // namespace

// Tried on a copy of the world, behind the inputs that the scene has for the same step. A copy costs little beside what
// a person can do in a second.
std::vector<sim::Command> LiveInputs::check(const Recorder& recorder, std::vector<sim::Command> inputs,
                                            std::vector<std::string>& refused) {
  if (inputs.empty()) return inputs;
  next_id_ = std::max(next_id_, id_above(recorder));
  sim::World trial = recorder.world();
  const std::uint64_t step = trial.state().step + 1;
  for (const sim::TimedCommand& input : recorder.scene().inputs) {
    if (input.step == step && !sim::apply(trial, input.command).ok()) return inputs;  // the step will say why
  }
  std::vector<sim::Command> accepted;
  for (sim::Command& input : inputs) {
    if (auto* thrown = std::get_if<sim::Throw>(&input)) thrown->box.id = next_id_++;
    const Status ok = sim::apply(trial, input);
    if (ok.ok()) {
      accepted.push_back(std::move(input));
    } else {
      refused.push_back(ok.error().message);
    }
  }
  return accepted;
}

}  // namespace tumble::replay
