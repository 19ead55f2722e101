#include "golden/hunt/judge_scene.h"

#include <algorithm>
#include <filesystem>

#include "golden/hunt/engine/engine_relations.h"
#include "golden/hunt/engine/trace_engine.h"
#include "golden/hunt/judge/features.h"
#include "golden/hunt/judge/same_bits.h"
#include "golden/suite/temporary_folder.h"
#include "golden/suite/text_files.h"
#include "src/base/check.h"
#include "src/process/run_child.h"
#include "tumble/replay/log_reader.h"

namespace tumble::hunt {
namespace {

using sim::length;

constexpr double kPatience = 60;  // s that another build may take for one scene

Judgement compare_log(const Trace& trace, replay::LogReader& log) {
  const sim::Method method = trace.scene.world.method;
  const std::uint64_t steps = std::min<std::uint64_t>(log.last_step(), trace.steps.size());
  for (std::uint64_t k = 1; k <= steps; ++k) {
    const Result<const replay::StepRecord*> record = log.read_step(k);
    if (!record.ok()) return broken(k, 0, "the other build's log cannot be read: " + record.error().message);
    const TracedStep& step = trace.steps[k - 1];
    const sim::Bodies& mine = trace.after(k - 1).bodies;
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
  if (log.last_step() == trace.steps.size()) return held();
  return broken(steps, 0, "the other build's session has another number of steps");
}

// Records the scene with another build, in a folder of its own, and compares each state.
Judgement judge_against(const std::string& program, const Trace& trace, const TextScene& scene) {
  const golden::TemporaryFolder folder("tumble-hunt");
  if (folder.path().empty()) return not_applicable("no temporary folder could be made");
  const std::filesystem::path toml = folder.path() / "scene.toml", log = folder.path() / "s.tumble";
  const std::filesystem::path said = folder.path() / "said";
  if (const Status ok = golden::write_file(toml, scene.text); !ok.ok()) return not_applicable(ok.error().message);
  process::Program child;
  child.words = {program, "record", toml.string(), "-o", log.string()};
  child.out = child.err = said.string();
  const Result<process::ChildEnd> end = process::run_child(child, kPatience);
  if (!end.ok()) return not_applicable("the other build does not start: " + end.error().message);
  if (end->exit == 2) return not_applicable("the other build refuses the scene");
  if (!end->well() && end->exit != 4) return broken(0, 0, "the other build " + end->text());
  Result<replay::LogReader> reader = replay::LogReader::open(log.string());
  if (!reader.ok()) return broken(0, 0, "the other build's log: " + reader.error().message);
  return compare_log(trace, *reader);
}

}  // namespace

Result<Trace> trace_of(const Question& question, const sim::SceneDef& scene) {
  return question.engine ? trace_engine(*question.engine, scene) : trace(scene);
}

bool is_claimed(const Question& question, const std::string& relation) {
  if (!question.engine) return true;
  const auto claim = question.engine->claims.find(relation);
  return claim != question.engine->claims.end() && claim->second;
}

std::vector<std::string> names_of(const Question& question) {
  std::vector<std::string> names;
  const auto wanted = [&](const std::string& name) {
    return question.only.empty() || std::ranges::find(question.only, name) != question.only.end();
  };
  for (const Relation& one : relations()) {
    if (wanted(one.name)) names.emplace_back(one.name);
  }
  if (!question.against.empty()) names.emplace_back(kAgainst);
  return names;
}

Judgement judge(const Question& question, const std::string& relation, const Trace& trace, const TextScene& scene) {
  if (!trace.failure.empty() && relation != "finishes") return not_applicable("the session ends early");
  if (relation == kAgainst) return judge_against(question.against, trace, scene);
  const Relation* known = find_relation(relation);
  SIM_CHECK(known != nullptr, std::string_view(relation));
  return question.engine && !known->is_law ? judge_engine(relation, trace) : known->judge(trace);
}

Judged judge_scene(const Question& question, const TextScene& scene) {
  Judged out;
  const auto run = [&question, &out](const sim::SceneDef& def) {
    Result<Trace> session = trace_of(question, def);
    if (question.engine && !session.ok() && session.error().kind == ErrorKind::kCannotFinish)
      out.unable = session.error().message;
    return session;
  };
  Result<Trace> session = run(scene.scene);
  if (!session.ok()) {
    out.problem = session.error().message;
    return out;
  }
  session->again = run;
  out.features = features_of(*session);
  for (const std::string& name : names_of(question)) {
    out.judgements.emplace_back(name, judge(question, name, *session, scene));
  }
  return out;
}

}  // namespace tumble::hunt
