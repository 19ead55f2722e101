#include "tumble/replay/continuation.h"

#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "replay/session/boxes_at.h"
#include "tumble/replay/player.h"
#include "tumble/sim/limits.h"

namespace tumble::replay {
namespace {

/// The inputs of a log, on both sides of state k.
struct Inputs {
  std::vector<sim::BoxDef> thrown;         // before it
  std::vector<sim::TimedCommand> to_come;  // after it
};

/// Reads the inputs of all steps. Steps of the log come first; after its last step, the scene still has the inputs that
/// a session which stopped early did not reach.
/// Of steps that a recovered log lost before state k, the state has what came of their inputs; those after it are
/// needed: needs_all.
Result<Inputs> inputs_around(LogReader& log, std::uint64_t k, bool needs_all) {
  Inputs inputs;
  for (std::uint64_t step = log.first_state() + 1; step <= log.last_step(); ++step) {
    if (log.lost_at(step) != nullptr) {
      if (step <= k || !needs_all) continue;
      return bad_input(log.name() + ": step " + std::to_string(step) +
                       " is lost, and with it the inputs before it: wanted no inputs of the log after step " +
                       std::to_string(k) + ", or a state behind the gap");
    }
    const Result<const StepRecord*> record = log.read_hashes(step);
    if (!record.ok()) return record.error();
    for (const sim::Command& command : (*record)->inputs) {
      const auto* thrown = std::get_if<sim::Throw>(&command);
      if (step > k) {
        inputs.to_come.push_back({step, command});
      } else if (thrown != nullptr) {
        inputs.thrown.push_back(thrown->box);
      }
    }
  }
  for (const sim::TimedCommand& input : log.header().scene.inputs) {
    if (input.step > log.last_step()) inputs.to_come.push_back(input);
  }
  return inputs;
}

std::vector<sim::TimedCommand> planned_after(const LogReader& log, std::uint64_t k) {
  std::vector<sim::TimedCommand> planned;
  for (const sim::TimedCommand& input : log.header().scene.inputs) {
    if (input.step > k) planned.push_back(input);
  }
  return planned;
}

/// State k with its hidden part (solver memory, rest times). A log stores hidden state in keyframes only, so this build
/// simulates from the last one. Its visible hash must be the log's; a build of another method version may agree in what
/// is visible and differ in what is hidden, and is refused before.
Result<sim::WorldState> state_at(LogReader& log, std::uint64_t k) {
  if (Status ok = must_be_ours(log); !ok.ok()) return ok.error();
  const LogHeader& header = log.header();
  const std::uint32_t ours = sim::method_version(header.scene.world.method);
  if (header.method_version != ours) {
    return cannot_finish(log.name() + ": was recorded with version " + std::to_string(header.method_version) +
                         " of method " + header.method + ", this build has version " + std::to_string(ours) +
                         " and would not go on to the bit; use the build that wrote it, or record the scene again");
  }
  Result<Player> player = Player::at(log, k);
  if (!player.ok()) return player.error();
  const sim::WorldState& state = player->world().state();
  const Result<const StepRecord*> logged = log.read_hashes(k);
  if (!logged.ok()) return logged.error();
  const Hash128 computed = sim::state_hash(state.bodies);
  if (computed == (*logged)->state_hash) return state;
  return cannot_finish(log.name() + ": step " + std::to_string(k) + ": this build computes state hash " +
                       to_string(computed) + ", the log has " + to_string((*logged)->state_hash) +
                       "; 'tumble replay' says where they part");
}

}  // namespace

Result<Continuation> continuation_of(LogReader& log, std::uint64_t k, const GoOnOptions& options) {
  Result<sim::WorldState> state = state_at(log, k);
  if (!state.ok()) return state.error();
  Result<Inputs> inputs = inputs_around(log, k, options.keep_inputs && !options.planned_only);
  if (!inputs.ok()) return inputs.error();
  const Result<Hash128> chain = log.chain_at(k);
  if (!chain.ok()) return chain.error();

  // The new scene is the old one as it is at state k: a reader of the new log needs nothing of the old one.
  sim::SceneDef scene = log.header().scene;
  std::vector<sim::BoxDef> known = std::move(scene.boxes);
  known.insert(known.end(), inputs->thrown.begin(), inputs->thrown.end());
  scene.boxes = boxes_at(state->bodies, std::move(known));
  scene.world = state->def;
  scene.inputs.clear();
  if (options.keep_inputs) scene.inputs = options.planned_only ? planned_after(log, k) : std::move(inputs->to_come);
  if (options.steps) scene.steps = k + *options.steps;
  if (options.seconds) scene.steps = k + static_cast<std::uint64_t>(std::llround(*options.seconds / state->def.dt));
  if (scene.steps <= k || scene.steps > sim::kStepsMax) {
    return bad_input(log.name() + ": found an end after step " + std::to_string(scene.steps) +
                     ", wanted one after step " + std::to_string(k) + " and up to step " +
                     std::to_string(sim::kStepsMax) + "; say how many steps to go on");
  }
  LogHeader header = header_for(scene);
  header.states = options.states;
  header.hashes = options.hashes;
  header.scene_text = log.header().scene_text;
  header.overrides = log.header().overrides;
  header.transform = log.header().transform;
  header.goes_on = {k, log.name(), sim::continuation_hash(*state), *chain};
  return Continuation{std::move(header), *std::move(state)};
}

}  // namespace tumble::replay
