#include "golden/hunt/judge_scene.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "golden/hunt/engine/judge_trace.h"
#include "golden/hunt/engine/trace_engine.h"
#include "golden/hunt/judge/features.h"
#include "golden/hunt/other_build.h"
#include "golden/suite/text_files.h"
#include "src/base/text.h"
#include "tumble/sim/step.h"

namespace tumble::hunt {
namespace {

// What is done next, where somebody wants to know. A file that cannot be written leaves it unsaid.
void tell_next(const Question& question, const std::string& relation) {
  if (!question.told.empty()) (void)golden::write_file(question.told, relation);
}

bool is_against(const std::string& relation) { return relation == kAgainst || measure_of(relation); }

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
  if (!question.against.empty()) known.emplace_back(kAgainst);
  std::vector<std::string> measures;
  for (const ApartBound& bound : question.within) measures.push_back(relation_of(bound));
  known.insert(known.end(), measures.begin(), measures.end());
  for (const auto& [where, name] : names) {
    if (is_against(name) && question.against.empty()) {
      return bad_input(where + ": found " + in_quotes(name) +
                       " without --against, wanted --against PROGRAM, the build whose sessions are compared");
    }
    if (measure_of(name) && std::ranges::find(measures, name) == measures.end()) {
      return bad_input(where + ": found " + in_quotes(name) + ", of which --within has no bound, wanted --within " +
                       *measure_of(name) + "=AMOUNT or --within bounds besides");
    }
    if (is_against(name)) continue;
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
  if (question.against.empty()) return names;
  // All of them, unless some are chosen.
  const bool chosen = std::ranges::any_of(question.only, is_against);
  if (!chosen || wanted(kAgainst)) names.emplace_back(kAgainst);
  for (const ApartBound& bound : question.within) {
    if (!chosen || wanted(relation_of(bound))) names.push_back(relation_of(bound));
  }
  return names;
}

Judgement judge(const Question& question, const std::string& relation, const Trace& trace, const TextScene& scene) {
  if (!is_against(relation)) return judge_trace(relation, trace);
  return OtherBuild(question.against, question.within, question.scratch, trace, scene).judge(relation);
}

Judged judge_scene(const Question& question, const TextScene& scene, bool with_features) {
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
  if (with_features) out.features = features_of(*session);
  out.ran = session->ran;
  OtherBuild other(question.against, question.within, question.scratch, *session,
                   scene);  // one session for all measures
  for (const std::string& name : names_of(question)) {
    tell_next(question, name);
    out.judgements.emplace_back(name, is_against(name) ? other.judge(name) : judge_trace(name, *session));
  }
  return out;
}

}  // namespace tumble::hunt
