#include "golden/judge/case_result.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "replay/measure/metric_list.h"

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

Json metric_json(const MetricResult& metric) {
  const MetricRule& rule = metric.rule;
  const replay::MetricRow* row = replay::find_metric(rule.name);
  return {{"name", rule.name},
          {"group", row == nullptr ? "" : row->group},
          {"unit", metric.unit},
          {"bodies", rule.bodies},
          {"axis", rule.axis},
          {"from_step", rule.from_step},
          {"value", or_null(metric.value)},
          {"blessed", or_null(rule.value)},
          {"min", or_null(rule.min)},
          {"max", or_null(rule.max)},
          {"why", rule.why},
          {"pass", metric.pass},
          {"words", metric.message}};
}

MetricResult metric_from(const Json& json) {
  MetricResult metric;
  metric.rule.name = json.at("name");
  metric.unit = json.at("unit");
  metric.rule.bodies = json.at("bodies");
  metric.rule.axis = json.at("axis");
  metric.rule.from_step = json.at("from_step");
  metric.value = optional_at<double>(json, "value");
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

Json difference_json(const FirstDifference& difference) {
  return {{"step", difference.step},       {"substep", or_null(difference.substep)},
          {"phase", difference.phase},     {"states_from", or_null(difference.states_from)},
          {"words", describe(difference)}, {"details", difference.details}};
}

FirstDifference difference_from(const Json& json) {
  return {json.at("step"), optional_at<std::uint32_t>(json, "substep"), json.at("phase"),
          optional_at<std::uint64_t>(json, "states_from"), json.at("details")};
}

Outcome outcome_from(const std::string& word) {
  const auto found = std::ranges::find(kOutcomeNames, word);
  return static_cast<Outcome>(found == kOutcomeNames.end() ? 2 : found - kOutcomeNames.begin());
}

CaseResult result_from(const Json& json) {
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
  for (const Json& metric : json.at("metrics")) result.metrics.push_back(metric_from(metric));
  for (const Json& picture : json.at("pictures")) result.pictures.push_back(picture_from(picture));
  if (!json.at("difference").is_null()) result.difference = difference_from(json.at("difference"));
  result.final_hash = json.at("final_hash");
  result.artifacts = json.at("artifacts");
  result.reproduce = json.at("reproduce");
  result.bless = json.at("bless");
  return result;
}

/// A problem without its advice.
std::string short_problem(const CaseResult& result) {
  const std::string& problem = result.problems.front();
  return problem.starts_with("stale") || problem.starts_with("no ") ? problem.substr(0, problem.find(':')) : problem;
}

}  // namespace

bool CaseResult::passed() const {
  if (!problems.empty() || require.empty()) return false;
  return std::ranges::all_of(require, [&](VerdictKind kind) { return verdict(kind).outcome == Outcome::kPass; });
}

std::string summary(const CaseResult& result) {
  const Outcome exact = result.verdict(VerdictKind::kExact).outcome;
  const Outcome behaviour = result.verdict(VerdictKind::kBehaviour).outcome;
  const char* bits = exact == Outcome::kPass ? "same bits" : "bits moved";
  const char* metrics = behaviour == Outcome::kPass ? "behaviour same" : "behaviour changed";
  if (exact == Outcome::kNone && behaviour == Outcome::kNone) {
    return result.problems.empty() ? "nothing was judged" : result.problems.front();
  }
  std::string text = exact == Outcome::kNone ? metrics : std::string(bits) + ", " + metrics;
  if (behaviour == Outcome::kNone) text = std::string(bits) + ", behaviour not judged";
  const Outcome image = result.verdict(VerdictKind::kImage).outcome;
  if (image == Outcome::kPass) text += ", same pictures";
  if (image == Outcome::kFail) text += ", pictures changed";
  if (!result.problems.empty()) text += "; " + short_problem(result);
  return text;
}

Json to_json(const CaseResult& result) {
  Json json = {{"name", result.name},       {"title", result.title},      {"category", result.category},
               {"passed", result.passed()}, {"summary", summary(result)}, {"steps", result.steps},
               {"bodies", result.bodies},   {"seconds", result.seconds}};
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
  json["metrics"] = Json::array();
  for (const MetricResult& metric : result.metrics) json["metrics"].push_back(metric_json(metric));
  json["pictures"] = Json::array();
  for (const PictureResult& picture : result.pictures) json["pictures"].push_back(picture_json(picture));
  json["difference"] = result.difference ? difference_json(*result.difference) : Json(nullptr);
  json["final_hash"] = result.final_hash;
  json["artifacts"] = result.artifacts;
  json["reproduce"] = result.reproduce;
  json["bless"] = result.bless;
  return json;
}

Result<CaseResult> case_from_json(const std::string& text) {
  try {
    return result_from(Json::parse(text));
  } catch (const Json::exception& error) {
    return cannot_finish(std::string("the result of a case cannot be read: ") + error.what());
  }
}

}  // namespace tumble::golden
