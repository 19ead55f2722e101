#include <memory>

#include "golden/hunt/judge/same_bits.h"
#include "replay/log/byte_memory.h"
#include "tumble/replay/player.h"
#include "tumble/replay/recorder.h"

namespace tumble::hunt {
namespace {

Judgement log_failed(std::uint64_t step, const std::string& message) {
  return broken(step, 0, "the log or its replay ends there: " + message);
}

// The log's record of a step, against the trace.
Judgement compare_record(const Trace& trace, std::size_t k, const replay::StepRecord& record, const char* whose) {
  const sim::Method method = trace.scene.world.method;
  const std::string phase = first_phase(method, trace.steps[k].words, record.phase_words);
  Judgement out;
  if (record.state_hash != state_hash(trace.after(k).bodies)) {
    out = broken(k + 1, 0, std::string(whose) + " has another state");
  } else if (record.phase_words != trace.steps[k].words) {
    out = broken(k + 1, 0, std::string(whose) + " has other hashes of phases");
  } else if (!(record.counters == trace.steps[k].counters) || record.dt != trace.steps[k].dt) {
    out = broken(k + 1, 0, std::string(whose) + " has other counts, energies or another dt");
  }
  out.phase = out.outcome == Outcome::kBroken ? phase : "";
  return out;
}

Judgement compare_log(const Trace& trace, replay::LogReader& log) {
  if (log.last_step() != trace.steps.size()) return log_failed(log.last_step(), "another number of steps");
  for (std::size_t k = 0; k < trace.steps.size(); ++k) {
    const Result<const replay::StepRecord*> record = log.read_step(k + 1);
    if (!record.ok()) return log_failed(k + 1, record.error().message);
    Judgement one = compare_record(trace, k, **record, "the log");
    if (one.outcome != Outcome::kHeld) return one;
    const replay::BodyStates& states = (*record)->states;
    if (states.position.x != trace.after(k).bodies.position.x || states.spin.z != trace.after(k).bodies.spin.z)
      return broken(k + 1, 0, "the states in the log are not those of their hash");
  }
  return held();
}

Judgement compare_player(const Trace& trace, replay::LogReader& log, std::size_t from) {
  Result<replay::Player> player = replay::Player::at(log, from);
  if (!player.ok()) return log_failed(from, player.error().message);
  for (std::size_t k = from; k < trace.steps.size(); ++k) {
    const Result<const replay::StepRecord*> record = player->step_hashes();
    if (!record.ok()) return log_failed(k + 1, record.error().message);
    Judgement one = compare_record(trace, k, **record, "the replay");
    if (one.outcome != Outcome::kHeld) return one;
  }
  return held();
}

}  // namespace

Judgement judge_replayed(const Trace& trace) {
  const auto file = std::make_shared<std::vector<std::byte>>();
  auto recorder = replay::Recorder::start(std::make_unique<replay::MemoryByteSink>(file, "hunt"), trace.scene, {});
  if (!recorder.ok()) return log_failed(0, recorder.error().message);
  if (const Status ok = (*recorder)->run(); !ok.ok()) return log_failed(0, ok.error().message);
  if (const auto summary = (*recorder)->finish(); !summary.ok()) return log_failed(0, summary.error().message);
  Result<replay::LogReader> log = replay::LogReader::open(std::make_unique<replay::MemoryByteSource>(file, "hunt"));
  if (!log.ok()) return log_failed(0, log.error().message);
  Judgement out = compare_log(trace, *log);
  for (const std::size_t from : {std::size_t{0}, trace.steps.size() / 2}) {
    if (out.outcome == Outcome::kHeld) out = compare_player(trace, *log, from);
  }
  return out;
}

}  // namespace tumble::hunt
