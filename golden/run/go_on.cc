#include "golden/run/go_on.h"

#include <string>
#include <utility>
#include <vector>

#include "golden/hunt/judge/same_bits.h"
#include "replay/codec/chunk_codec.h"
#include "src/base/text.h"
#include "tumble/replay/session.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/step.h"

namespace tumble::golden {
namespace {

constexpr const char* kOfAnEngine =
    "not gone on with from each step: the session is another engine's, whose states Tumble cannot load";

// The step that leads to state `step`, taken from a snapshot of the state before. Empty: it is the session's.
std::string fault_of_step(sim::Method method, std::uint64_t step, const Result<sim::WorldState>& loaded,
                          const Hash128& saved, const std::vector<sim::Command>& inputs,
                          const hunt::StepTaken& wanted) {
  const std::string where = "step " + std::to_string(step) + " from a snapshot: ";
  if (!loaded.ok()) return where + "it cannot be read back: " + loaded.error().message;
  if (sim::continuation_hash(*loaded) != saved) return where + "what is read back is another state than was written";
  Result<replay::Session> again = replay::Session::resume(*loaded);
  if (!again.ok()) return where + "its state is refused: " + again.error().message;
  sim::PhaseHashes hashes;
  const Result<replay::TakenStep> taken = again->step(inputs, &hashes);
  if (!taken.ok()) return where + taken.error().message;
  const hunt::Judgement judged =
      hunt::compare_steps(method, step, wanted, {again->world().state(), hashes.words(), taken->counters});
  return judged.outcome == hunt::Outcome::kBroken ? "from a snapshot of the state before, " + describe(judged) : "";
}

}  // namespace

Result<sim::WorldState> saved_and_loaded(const sim::WorldState& state) {
  replay::ChunkEncoder encoder;
  const Result<replay::MessageBytes> bytes = encoder.encode({state, sim::continuation_hash(state)}, {});
  if (!bytes.ok()) return bytes.error();
  const Result<replay::ChunkDecoder> chunk = replay::ChunkDecoder::open(*bytes);
  if (!chunk.ok()) return chunk.error();
  return chunk->keyframe().state;
}

Result<std::string> first_step_gone_on_otherwise(const sim::SceneDef& scene, const Reload& reload, std::uint64_t& steps,
                                                 Hash128& final_hash) {
  Result<replay::Session> session = replay::Session::start(scene);
  if (!session.ok()) return session.error();
  while (session->steps_done() < scene.steps) {
    const Hash128 saved = sim::continuation_hash(session->world().state());
    const Result<sim::WorldState> loaded = reload(session->world().state());
    sim::PhaseHashes hashes;
    const Result<replay::TakenStep> taken = session->step({}, &hashes);
    if (!taken.ok()) return taken.error();
    ++steps;
    const std::vector<std::uint64_t> words = hashes.words();
    const std::vector<sim::Command> inputs(taken->inputs.begin(), taken->inputs.end());
    std::string fault = fault_of_step(scene.world.method, steps, loaded, saved, inputs,
                                      {session->world().state(), words, taken->counters});
    if (!fault.empty()) return fault;
  }
  final_hash = sim::state_hash(session->world().bodies());
  return std::string();
}

void go_on_from_each_step(const LawSession& session, const CaseRules& rules, CaseResult& result) {
  if (rules.is_external()) {
    result.gone_on = kOfAnEngine;
    return;
  }
  std::uint64_t steps = 0;
  Hash128 final_hash;
  const Result<std::string> fault = first_step_gone_on_otherwise(session.scene, saved_and_loaded, steps, final_hash);
  std::string problem;
  if (!fault.ok()) {
    problem = fault.error().message;
  } else if (!fault->empty()) {
    problem = *fault;
  } else if (to_string(final_hash) != result.final_hash) {
    problem = "this build takes the scene to other bits than the session has";
  }
  result.was_gone_on = true;
  result.gone_on = "gone on with from each of " + count_text(steps, "step") + (problem.empty() ? ": same bits" : "");
  if (!problem.empty()) result.problems.push_back("saved and gone on with: " + problem);
}

}  // namespace tumble::golden
