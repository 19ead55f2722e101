#include "golden/hunt/judge_scene.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "golden/hunt/engine/judge_trace.h"
#include "golden/hunt/engine/trace_engine.h"
#include "golden/hunt/judge/features.h"
#include "golden/hunt/judge/same_bits.h"
#include "golden/suite/temporary_folder.h"
#include "golden/suite/text_files.h"
#include "src/base/text.h"
#include "src/process/run_child.h"
#include "tumble/replay/log_reader.h"
#include "tumble/sim/step.h"

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
Judgement judge_against(const Question& question, const Trace& trace, const TextScene& scene) {
  const golden::TemporaryFolder folder("scene", question.scratch);
  if (folder.path().empty()) return not_applicable("no temporary folder could be made");
  const std::filesystem::path toml = folder.path() / "scene.toml", log = folder.path() / "s.tumble";
  const std::filesystem::path said = folder.path() / "said";
  if (const Status ok = golden::write_file(toml, scene.text); !ok.ok()) return not_applicable(ok.error().message);
  process::Program child;
  child.words = {question.against, "record", toml.string(), "-o", log.string()};
  child.own_group = false;  // it ends with the process that judges
  child.out = child.err = said.string();
  const Result<process::ChildEnd> end = process::run_child(child, kPatience);
  if (end.ok() && end->late) process::end_own_group();
  if (!end.ok()) return not_applicable("the other build does not start: " + end.error().message);
  if (end->exit == 2) return not_applicable("the other build refuses the scene");
  if (!end->well() && end->exit != 4) return broken(0, 0, "the other build " + end->text());
  Result<replay::LogReader> reader = replay::LogReader::open(log.string());
  if (!reader.ok()) return broken(0, 0, "the other build's log: " + reader.error().message);
  return compare_log(trace, *reader);
}

// Compares parts of Tumble with one another.
bool is_tumbles_own(std::string_view relation) {
  static constexpr std::array kOwn = {"threads", "lanes", "resumed", "replayed"};
  return std::ranges::find(kOwn, relation) != kOwn.end();
}

}  // namespace

Status check_question(const Question& question) {
  std::vector<std::string_view> known;
  for (const Relation& one : relations()) known.emplace_back(one.name);
  std::vector<std::pair<std::string, std::string>> names;
  for (const std::string& name : question.only) names.emplace_back("--relation", name);
  if (question.engine) {
    const std::string file = question.engine->file.string();
    if (question.engine->run.find("{scene}") == std::string::npos) {
      return bad_input(file + ": [engine] run: found no {scene} in " + in_quotes(question.engine->run) +
                       ", wanted it where the file of a hunt's scene goes");
    }
    for (const auto& [name, claimed] : question.engine->claims) {
      const auto place = question.engine->claim_places.find(name);
      const bool is_known = place != question.engine->claim_places.end();
      names.emplace_back(file + (is_known ? ":" + place->second : "") + ": [engine.claims]", name);
    }
  }
  for (const auto& [where, name] : names) {
    if (question.engine && is_tumbles_own(name)) {
      return bad_input(where + ": found " + in_quotes(name) +
                       ", which compares parts of Tumble, wanted a relation or law of an engine; leave it out");
    }
    if (find_relation(name) != nullptr) continue;
    const std::string_view nearest = nearest_word(name, known);
    return bad_input(where + ": found " + in_quotes(name) + ", wanted " + list_text(known) +
                     (nearest.empty() ? "" : "; did you mean \"" + std::string(nearest) + "\"?"));
  }
  return {};
}

Result<Trace> trace_of(const Question& question, const sim::SceneDef& scene) {
  return question.engine ? trace_engine(*question.engine, scene, question.scratch) : trace(scene);
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
  if (relation != kAgainst) return judge_trace(relation, trace);
  return trace.failure.empty() ? judge_against(question, trace, scene) : not_applicable("the session ends early");
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
    out.refused =
        question.engine && session.error().kind == ErrorKind::kBadInput && sim::create_world(scene.scene).ok();
    return out;
  }
  session->again = run;
  out.features = features_of(*session);
  out.ran = session->ran;
  for (const std::string& name : names_of(question)) {
    out.judgements.emplace_back(name, judge(question, name, *session, scene));
  }
  return out;
}

}  // namespace tumble::hunt
