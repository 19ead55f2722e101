#include "golden/hunt/other_build.h"

#include <algorithm>
#include <utility>

#include "golden/hunt/judge/same_bits.h"
#include "golden/suite/text_files.h"
#include "src/process/run_child.h"
#include "tumble/sim/step.h"

namespace tumble::hunt {
namespace {

using sim::length;

constexpr double kPatience = 60;  // s that another build may take for one scene

}  // namespace

Judgement OtherBuild::judge(const std::string& relation) {
  if (!trace_.failure.empty()) return not_applicable("the session ends early");
  if (!session_) session_ = judge_session();
  const auto bound = std::ranges::find(within_, relation, relation_of);
  if (bound == within_.end()) return *session_;
  if (session_->outcome != Outcome::kHeld) return not_applicable("no whole session to compare with: " + session_->what);
  return judge_measure(*bound);
}

// Records the scene with the other build, in a folder of its own, and reads each state.
Judgement OtherBuild::judge_session() {
  Judgement recorded = record();
  if (recorded.outcome != Outcome::kHeld) return recorded;
  return within_.empty() ? compare_bits() : read_records();
}

Judgement OtherBuild::record() {
  folder_ = std::make_unique<golden::TemporaryFolder>("scene", scratch_);
  const std::filesystem::path& place = folder_->path();
  if (place.empty()) return not_applicable("no temporary folder could be made");
  const std::filesystem::path toml = place / "scene.toml", log = place / "s.tumble", said = place / "said";
  if (const Status ok = golden::write_file(toml, scene_.text); !ok.ok()) return not_applicable(ok.error().message);
  process::Program child;
  child.words = {program_, "record", toml.string(), "-o", log.string()};
  child.own_group = false;  // it ends with the process that judges
  child.out = child.err = said.string();
  const Result<process::ChildEnd> end = process::run_child(child, kPatience);
  if (end.ok() && end->late) process::end_own_group();
  if (!end.ok()) return not_applicable("the other build does not start: " + end.error().message);
  if (end->exit == 2) return not_applicable("the other build refuses the scene");
  if (!end->well() && end->exit != 4) return broken(0, 0, "the other build " + end->text());
  Result<replay::LogReader> reader = replay::LogReader::open(log.string());
  if (!reader.ok()) return broken(0, 0, "the other build's log: " + reader.error().message);
  log_.emplace(*std::move(reader));
  return held();
}

Judgement OtherBuild::compare_bits() {
  const sim::Method method = trace_.scene.world.method;
  const std::uint64_t steps = std::min<std::uint64_t>(log_->last_step(), trace_.steps.size());
  for (std::uint64_t k = 1; k <= steps; ++k) {
    const Result<const replay::StepRecord*> record = log_->read_step(k);
    if (!record.ok()) return broken(k, 0, "the other build's log cannot be read: " + record.error().message);
    const TracedStep& step = trace_.steps[k - 1];
    const sim::Bodies& mine = trace_.after(k - 1).bodies;
    if ((*record)->state_hash == state_hash(mine)) continue;
    Judgement out = broken(k, 0, "the other build has another state");
    const replay::BodyStates& other = (*record)->states;
    for (sim::BodyIndex i = 0; i < std::min(mine.size(), other.id.size()); ++i) {
      const sim::Vec3 x = other.position[i] - mine.position[i], v = other.velocity[i] - mine.velocity[i];
      out.value = std::max(out.value, std::max(length(x), length(v)));
      if (out.body == 0 && (length(x) > 0 || length(v) > 0)) out.body = mine.id[i];
    }
    out.phase = first_phase(method, step.words, (*record)->phase_words);
    return out;
  }
  if (log_->last_step() == trace_.steps.size()) return held();
  return broken(steps, 0, "the other build's session has another number of steps");
}

// All states of the other session, beside those of the trace where any bit differs.
Judgement OtherBuild::read_records() {
  const std::uint64_t steps = trace_.steps.size();
  if (log_->last_step() != steps) {
    return broken(std::min(log_->last_step(), steps), 0,
                  "the other build's session ends with step " + std::to_string(log_->last_step()) + ", this one with " +
                      std::to_string(steps));
  }
  std::vector<replay::StepRecord> other;
  bool same_bits = true;
  for (std::uint64_t k = 0; k <= steps; ++k) {
    const Result<const replay::StepRecord*> record = log_->read_step(k);
    if (!record.ok()) return broken(k, 0, "the other build's log cannot be read: " + record.error().message);
    if (!(*record)->has_states) return broken(k, 0, "the other build's log holds no states of the step");
    same_bits = same_bits && (*record)->state_hash == state_hash(trace_.states[k].bodies);
    other.push_back(**record);
  }
  if (!same_bits) pair_.emplace(trace_, other);
  return held();
}

Judgement OtherBuild::judge_measure(const ApartBound& bound) const { return pair_ ? pair_->judge(bound) : held(); }

}  // namespace tumble::hunt
