#include "golden/judge/case_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "replay/measure/metric_list.h"
#include "tumble/golden/change.h"

namespace tumble::golden {
namespace {

constexpr std::array<const char*, 3> kOutcomeNames = {"none", "pass", "fail"};

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

template <class T>
std::optional<T> optional_at(const Json& json, const char* key) {
  const Json& value = json.at(key);
  return value.is_null() ? std::nullopt : std::optional<T>(value.get<T>());
}

constexpr const char* kLawGroup = "law";  // in the place of a group of docs/metrics.md

Json metric_json(const MetricResult& metric) {
  const MetricRule& rule = metric.rule;
  const replay::MetricRow* row = replay::find_metric(rule.name);
  return {{"name", rule.name},
          {"group", rule.is_law      ? kLawGroup
                    : row == nullptr ? ""
                                     : row->group},
          {"unit", metric.unit},
          {"bodies", rule.bodies},
          {"axis", rule.axis},
          {"from_step", rule.from_step},
          {"value", or_null(metric.value)},
          {"spread", or_null(metric.spread)},
          {"blessed", or_null(rule.value)},
          {"min", or_null(rule.min)},
          {"max", or_null(rule.max)},
          {"why", rule.why},
          {"pass", metric.pass},
          {"moved", has_moved(metric)},
          {"words", metric.message}};
}

MetricResult metric_from(const Json& json) {
  MetricResult metric;
  metric.rule.name = json.at("name");
  metric.rule.is_law = json.at("group") == kLawGroup;
  metric.unit = json.at("unit");
  metric.rule.bodies = json.at("bodies");
  metric.rule.axis = json.at("axis");
  metric.rule.from_step = json.at("from_step");
  metric.value = optional_at<double>(json, "value");
  metric.spread = optional_at<double>(json, "spread");
  metric.rule.value = optional_at<double>(json, "blessed");
  metric.rule.min = optional_at<double>(json, "min");
  metric.rule.max = optional_at<double>(json, "max");
  metric.rule.why = json.at("why");
  metric.pass = json.at("pass");
  metric.message = json.at("words");
  return metric;
}

Json picture_json(const PictureResult& picture) {
  const PictureRule& rule = picture.rule;
  return {{"file", rule.file()},
          {"step", rule.step},
          {"width", rule.width},
          {"height", rule.height},
          {"freezing", rule.freezing},
          {"pixels", picture.pixels},
          {"far_off", picture.far_off},
          {"far_off_max", rule.far_off_max},
          {"why", rule.why},
          {"pass", picture.pass},
          {"words", picture.message}};
}

PictureResult picture_from(const Json& json) {
  PictureResult picture;
  picture.rule.step = json.at("step");
  picture.rule.width = json.at("width");
  picture.rule.height = json.at("height");
  picture.rule.freezing = json.at("freezing");
  picture.rule.far_off_max = json.at("far_off_max");
  picture.rule.why = json.at("why");
  picture.pixels = json.at("pixels");
  picture.far_off = json.at("far_off");
  picture.pass = json.at("pass");
  picture.message = json.at("words");
  return picture;
}

/// metres: null where a position is not a number.
Json apart_json(const Apart& apart) {
  return {{"metres", std::isfinite(apart.metres) ? Json(apart.metres) : Json(nullptr)},
          {"body", apart.body},
          {"step", apart.step},
          {"words", describe(apart)}};
}

Json difference_json(const FirstDifference& difference) {
  return {{"step", difference.step},
          {"substep", or_null(difference.substep)},
          {"phase", difference.phase},
          {"told", difference.told},
          {"states_from", or_null(difference.states_from)},
          {"apart", difference.apart ? apart_json(*difference.apart) : Json(nullptr)},
          {"words", describe(difference)},
          {"details", difference.details}};
}

FirstDifference difference_from(const Json& json) {
  FirstDifference difference{.step = json.at("step"),
                             .substep = optional_at<std::uint32_t>(json, "substep"),
                             .phase = json.at("phase"),
                             .told = json.value("told", ""),
                             .states_from = optional_at<std::uint64_t>(json, "states_from"),
                             .details = json.at("details"),
                             .apart = {}};
  if (const Json& apart = json.at("apart"); !apart.is_null()) {
    difference.apart = {optional_at<double>(apart, "metres").value_or(INFINITY), apart.at("step"), apart.at("body")};
  }
  return difference;
}

/// The size of the change; most: the metric that moved most, null if none did.
Json magnitude_json(const CaseResult& result) {
  const std::optional<Apart> apart = result.difference ? result.difference->apart : std::nullopt;
  const MetricResult* most = most_moved(result.metrics);
  Json json = {{"apart", apart ? apart_json(*apart) : Json(nullptr)},
               {"metrics", result.metrics.size()},
               {"metrics_moved", moved_metrics(result)},
               {"most", nullptr}};
  if (most == nullptr) return json;
  json["most"] = {{"name", most->rule.name},
                  {"before", or_null(most->rule.value)},
                  {"after", or_null(most->value)},
                  {"words", movement_text(*most)}};
  return json;
}

Outcome outcome_from(const std::string& word) {
  const auto found = std::ranges::find(kOutcomeNames, word);
  return static_cast<Outcome>(found == kOutcomeNames.end() ? 2 : found - kOutcomeNames.begin());
}

}  // namespace

CaseResult case_from(const Json& json) {
  CaseResult result;
  result.name = json.at("name");
  result.title = json.at("title");
  result.category = json.at("category");
  result.steps = json.at("steps");
  result.bodies = json.at("bodies");
  result.seconds = json.at("seconds");
  for (const Json& word : json.at("require")) {
    const Result<VerdictKind> kind = parse_verdict(word.get<std::string>());
    if (kind.ok()) result.require.push_back(*kind);
  }
  for (std::size_t k = 0; k < kVerdictNames.size(); ++k) {
    const Json& verdict = json.at("verdicts").at(kVerdictNames[k]);
    result.verdicts[k] = {outcome_from(verdict.at("outcome")), verdict.at("words")};
  }
  result.problems = json.at("problems");
  result.notes = json.at("notes");
  result.runs = json.at("runs");
  result.runs_message = json.at("runs_words");
  result.gone_on = json.value("gone_on", "");
  result.was_gone_on = json.value("was_gone_on", false);
  for (const Json& metric : json.at("metrics")) result.metrics.push_back(metric_from(metric));
  for (const Json& picture : json.at("pictures")) result.pictures.push_back(picture_from(picture));
  if (!json.at("difference").is_null()) result.difference = difference_from(json.at("difference"));
  for (const Json& change : json.at("scene_changes")) {
    result.scene_changes.push_back({change.at("line"), change.at("table"), change.at("before"), change.at("after")});
  }
  if (const Json& by = json.at("blessed_by"); !by.is_null()) result.blessed_by = provenance_from(by);
  result.continuation = json.at("continuation");
  result.final_hash = json.at("final_hash");
  result.artifacts = json.at("artifacts");
  result.reproduce = json.at("reproduce");
  result.bless = json.at("bless");
  result.bless_refused = json.at("bless_refused");
  return result;
}

Json to_json(const Provenance& provenance) {
  return {{"version", provenance.version},   {"commit", provenance.commit},   {"tree", provenance.tree},
          {"compiler", provenance.compiler}, {"flags", provenance.flags},     {"machine", provenance.machine},
          {"date", provenance.date},         {"seconds", provenance.seconds}, {"words", describe(provenance)}};
}

Provenance provenance_from(const Json& json) {
  return {.version = json.at("version"),
          .commit = json.at("commit"),
          .tree = json.at("tree"),
          .compiler = json.at("compiler"),
          .flags = json.at("flags"),
          .machine = json.at("machine"),
          .date = json.at("date"),
          .seconds = json.at("seconds")};
}

Json to_json(const CaseResult& result) {
  Json json = {{"name", result.name},       {"title", result.title},      {"category", result.category},
               {"passed", result.passed()}, {"summary", summary(result)}, {"steps", result.steps},
               {"bodies", result.bodies},   {"seconds", result.seconds}};
  json["change"] = key_of(change_of(result));
  json["magnitude"] = magnitude_json(result);
  json["require"] = Json::array();
  for (const VerdictKind kind : result.require)
    json["require"].push_back(kVerdictNames[static_cast<std::size_t>(kind)]);
  for (std::size_t k = 0; k < kVerdictNames.size(); ++k) {
    const Verdict& verdict = result.verdicts[k];
    json["verdicts"][kVerdictNames[k]] = {{"outcome", kOutcomeNames[static_cast<std::size_t>(verdict.outcome)]},
                                          {"words", verdict.message}};
  }
  json["problems"] = result.problems;
  json["notes"] = result.notes;
  json["runs"] = result.runs;
  json["runs_words"] = result.runs_message;
  if (!result.gone_on.empty()) {
    json["gone_on"] = result.gone_on;
    json["was_gone_on"] = result.was_gone_on;
  }
  json["metrics"] = Json::array();
  for (const MetricResult& metric : result.metrics) json["metrics"].push_back(metric_json(metric));
  json["pictures"] = Json::array();
  for (const PictureResult& picture : result.pictures) json["pictures"].push_back(picture_json(picture));
  json["difference"] = result.difference ? difference_json(*result.difference) : Json(nullptr);
  json["scene_changes"] = Json::array();
  for (const SceneChange& change : result.scene_changes) {
    json["scene_changes"].push_back({{"line", change.line},
                                     {"table", change.table},
                                     {"before", change.before},
                                     {"after", change.after},
                                     {"words", describe(change)}});
  }
  json["blessed_by"] = result.blessed_by ? to_json(*result.blessed_by) : Json(nullptr);
  json["continuation"] = result.continuation;
  json["final_hash"] = result.final_hash;
  json["artifacts"] = result.artifacts;
  json["reproduce"] = result.reproduce;
  json["bless"] = result.bless;
  json["bless_refused"] = result.bless_refused;
  return json;
}

Result<CaseResult> case_from_json(const std::string& text) {
  try {
    return case_from(Json::parse(text));
  } catch (const Json::exception& error) {
    return cannot_finish(std::string("the result of a case cannot be read: ") + error.what());
  }
}

}  // namespace tumble::golden
