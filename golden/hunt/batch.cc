#include "golden/hunt/batch.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "golden/hunt/engine/kept_run.h"
#include "golden/hunt/scene/grammar.h"

namespace tumble::hunt {
namespace {

std::string first_word(const std::string& title) { return title.substr(0, title.find(',')); }

// A large fault must not shrink to the least one that is just beyond the bound, which may be another fault.
constexpr double kTimesKept = 10;
double times_bound(const Judgement& one) { return std::isfinite(one.value) ? one.value / one.bound : kTimesKept; }

}  // namespace

Result<TextScene> drawn_scene(std::uint64_t seed, std::uint64_t number) { return settled(random_scene(seed, number)); }

Batch judge_batch(const Question& question, std::uint64_t seed, const Share& share, std::uint64_t first,
                  std::uint64_t scenes, bool with_features, const std::function<bool()>& enough) {
  Batch batch;
  batch.tallies.resize(names_of(question).size());
  for (std::uint64_t at = first; at < first + scenes && !enough(); ++at) {
    const std::uint64_t number = share.number(at);
    const Result<TextScene> scene = drawn_scene(seed, number);
    const Judged judged =
        scene.ok() ? judge_scene(question, *scene, with_features) : Judged{scene.error().message, {}, {}, {}, {}, {}};
    if (!judged.unable.empty()) {
      batch.unable = "scene " + std::to_string(number) + ": " + judged.unable;
      return batch;
    }
    ++batch.scenes;
    if (judged.refused && batch.refused++ == 0)
      batch.refusal = "scene " + std::to_string(number) + ": " + judged.problem;
    if (!judged.problem.empty() && !judged.refused) ++batch.no_scenes;
    bool broke = !judged.problem.empty();
    const std::size_t known = batch.findings.size();
    for (std::size_t k = 0; k < judged.judgements.size(); ++k) {
      const auto& [name, one] = judged.judgements[k];
      batch.tallies[k].count(one, number);
      broke |= one.outcome == Outcome::kBroken;
      if (one.outcome != Outcome::kBroken) continue;
      Finding finding;
      finding.seed = seed;
      finding.number = number;
      finding.relation = name;
      finding.kind = first_word(scene->scene.title);
      finding.judgement = one;
      batch.findings.push_back(std::move(finding));
    }
    if (batch.findings.size() > known && judged.ran && !question.runs.empty())
      set_aside(*judged.ran, question.runs / std::to_string(number));
    if (!broke && with_features) batch.features.emplace_back(number, judged.features);
  }
  return batch;
}

std::string to_text(const Batch& batch) {
  Json json = {{"unable", batch.unable},   {"scenes", batch.scenes},   {"no_scenes", batch.no_scenes},
               {"refused", batch.refused}, {"refusal", batch.refusal}, {"tallies", Json::array()},
               {"findings", Json::array()}};
  for (const Tally& one : batch.tallies) {
    json["tallies"].push_back(
        {one.held, one.broken, one.not_applicable, one.nearest ? Json(*one.nearest) : Json(), one.nearest_number});
  }
  for (const Finding& one : batch.findings) json["findings"].push_back(to_json(one));
  json["features"] = batch.features;
  return whole_text(json);
}

Result<Batch> batch_from(const std::string& text) {
  try {
    const Json json = Json::parse(text);
    if (const std::string unable = json.at("unable"); !unable.empty()) return cannot_finish(unable);
    Batch batch;
    batch.scenes = json.at("scenes");
    batch.no_scenes = json.at("no_scenes");
    batch.refused = json.at("refused");
    batch.refusal = json.at("refusal");
    for (const Json& one : json.at("tallies")) {
      const Json& nearest = one.at(3);
      batch.tallies.push_back({one.at(0), one.at(1), one.at(2),
                               nearest.is_null() ? std::nullopt : std::optional(nearest.get<double>()), one.at(4)});
    }
    for (const Json& one : json.at("findings")) batch.findings.push_back(finding_from(one));
    batch.features = json.at("features").get<decltype(batch.features)>();
    return batch;
  } catch (const Json::exception& problem) {
    return cannot_finish(std::string("what a child process found cannot be read: ") + problem.what());
  }
}

std::string judgements_text(const Judged& judged) {
  Json json = {{"problem", judged.problem},
               {"refused", judged.refused},
               {"unable", judged.unable},
               {"judgements", Json::array()}};
  for (const auto& [name, one] : judged.judgements) {
    json["judgements"].push_back({name, static_cast<int>(one.outcome), to_json(one)});
  }
  return whole_text(json);
}

Result<Judged> judgements_from(const std::string& text) {
  try {
    const Json json = Json::parse(text);
    if (const std::string unable = json.at("unable"); !unable.empty()) return cannot_finish(unable);
    Judged judged;
    judged.problem = json.at("problem");
    judged.refused = json.at("refused");
    for (const Json& one : json.at("judgements")) {
      Judgement judgement = judgement_from(one.at(2));
      judgement.outcome = static_cast<Outcome>(one.at(1).get<int>());
      judged.judgements.emplace_back(one.at(0), std::move(judgement));
    }
    return judged;
  } catch (const Json::exception& problem) {
    return cannot_finish(std::string("what a child process found cannot be read: ") + problem.what());
  }
}

Finding shrink_finding(const Question& question, Finding finding, std::uint64_t tries_most,
                       const std::function<bool()>& enough) {
  const Result<TextScene> scene = drawn_scene(finding.seed, finding.number);
  if (!scene.ok()) return finding;
  const double wanted = std::clamp(0.5 * times_bound(finding.judgement), 1.0, kTimesKept);
  const Test test = [&](const Trace& session, const TextScene& candidate) {
    Judgement one = judge(question, finding.relation, session, candidate);
    if (one.bound > 0 && times_bound(one) < wanted) one.outcome = Outcome::kHeld;
    return one;
  };
  const Tracer tracer = [&question](const sim::SceneDef& candidate) { return trace_of(question, candidate); };
  const Shrunk least = shrink(*scene, finding.judgement, test, tracer, tries_most, enough);
  TextScene named = least.scene;
  finding.shrunk_judgement = least.judgement;
  finding.bodies = named.scene.boxes.size();
  for (const sim::TimedCommand& input : named.scene.inputs) {
    if (std::holds_alternative<sim::Throw>(input.command)) ++finding.bodies;
  }
  finding.steps = named.scene.steps;
  finding.tried = least.tried;
  finding.least = least.least;
  named.scene.name = name_of(finding);
  named.scene.title = "";
  finding.shrunk_text = scene_text(named.scene);
  return finding;
}

}  // namespace tumble::hunt
