#include "golden/run/judge_laws.h"

#include <string>
#include <utility>

#include "golden/hunt/engine/judge_trace.h"
#include "golden/hunt/engine/trace_engine.h"
#include "golden/suite/read_laws.h"
#include "golden/suite/text_files.h"
#include "src/base/text.h"
#include "tumble/scenes/scene_file.h"
#include "tumble/sim/hash.h"

namespace tumble::golden {
namespace {

Result<hunt::Trace> own_trace(const LawSession& session, const CaseResult& result) {
  Result<hunt::Trace> trace = hunt::trace(session.scene);
  if (!trace.ok()) return trace;
  if (to_string(sim::state_hash(trace->states.back().bodies)) == result.final_hash) return trace;
  return bad_input("this build takes the scene to other bits than the session has");
}

// engine: outlives the trace.
Result<hunt::Trace> engine_trace(const LawSession& session, const CaseEngine& engine) {
  const std::string& file = engine.files.scene;
  if (file.empty()) return bad_input("the case's engine is handed no scene");
  const Result<std::string> text = read_text(file);
  if (!text.ok()) return text.error();
  const Result<sim::SceneDef> scene = scenes::parse_scene(*text, file);
  if (!scene.ok()) return bad_input("the engine's scene is none of Tumble's: " + scene.error().message);
  Result<hunt::Trace> trace = hunt::trace_of_log(session.log, *scene, engine.project);
  if (!trace.ok()) return trace;
  trace->again = [&session, &engine](const sim::SceneDef& other) -> Result<hunt::Trace> {
    if (!session.may_run) return bad_input("the engine is not run here");
    return hunt::trace_engine(engine.project, other, session.scratch);
  };
  return trace;
}

// The process that judges is alive after each.
hunt::Judgement judge_survival(const hunt::Trace& trace) {
  for (const hunt::Relation& one : hunt::relations()) (void)hunt::judge_trace(one.name, trace);
  return hunt::held();
}

hunt::Judgement judge_law(const std::string& law, const hunt::Trace& trace) {
  return law == kSurvivesLaw ? judge_survival(trace) : hunt::judge_trace(law, trace);
}

MetricResult result_of(const std::string& law, const hunt::Judgement& judged) {
  MetricResult out;
  out.rule.name = law;
  out.rule.is_law = true;
  out.rule.max = judged.bound;
  const hunt::Relation* known = hunt::find_relation(law);
  out.rule.why = known != nullptr ? known->claim : "no law and no relation ends the program that judges it";
  out.unit = judged.unit;
  out.pass = judged.outcome == hunt::Outcome::kHeld;
  if (judged.outcome == hunt::Outcome::kNotApplicable) {
    out.message = "not judged: " + judged.what;
    return out;
  }
  if (out.pass || judged.value > judged.bound) out.value = judged.value;
  if (!out.pass) out.message = describe(judged);
  return out;
}

}  // namespace

void judge_laws(const LawSession& session, const CaseRules& rules, CaseResult& result) {
  if (rules.laws.empty()) return;
  const Result<CaseEngine> engine =
      rules.is_external() ? engine_of_case(session.folder, rules, session.suite) : CaseEngine();
  const Result<hunt::Trace> trace = !rules.is_external() ? own_trace(session, result)
                                    : engine.ok()        ? engine_trace(session, *engine)
                                                         : Result<hunt::Trace>(engine.error());
  std::string failed;
  for (const std::string& law : rules.laws) {
    const hunt::Judgement judged = trace.ok() ? judge_law(law, *trace) : hunt::not_applicable(trace.error().message);
    result.metrics.push_back(result_of(law, judged));
    if (!result.metrics.back().pass) failed += (failed.empty() ? "" : ", ") + law;
  }
  Verdict& behaviour = result.verdict(VerdictKind::kBehaviour);
  std::string words = failed.empty() ? count_text(rules.laws.size(), "law") + " held" : "laws not held: " + failed;
  behaviour.message = behaviour.message.empty() ? std::move(words) : behaviour.message + "; " + words;
  if (!failed.empty()) behaviour.outcome = Outcome::kFail;
}

}  // namespace tumble::golden
