#include "tumble/golden/change.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "replay/measure/metric_list.h"
#include "src/base/text.h"

namespace tumble::golden {
namespace {

constexpr int kDigits = 4;
constexpr int kDigitsMax = 17;

/// How far a metric moved, as a part of the largest number that it is judged by. Infinite where a value came or went.
double relative_movement(const MetricResult& metric) {
  if (!has_moved(metric)) return 0;
  if (!metric.value || !metric.rule.value) return INFINITY;
  double scale = std::max(std::fabs(*metric.value), std::fabs(*metric.rule.value));
  for (const std::optional<double>& bound : {metric.rule.min, metric.rule.max}) {
    if (bound) scale = std::max(scale, std::fabs(*bound));
  }
  const double moved = std::fabs(*metric.value - *metric.rule.value) / scale;
  return std::isnan(moved) ? INFINITY : moved;
}

std::string with_unit(const std::optional<double>& value, int digits, const std::string& unit) {
  if (!value) return "null";
  if (!std::isfinite(*value)) return std::isnan(*value) ? "not a number" : "infinite";
  return significant(*value, digits) + (unit.empty() || unit == "bodies" || unit == "bounces" ? "" : " " + unit);
}

/// A problem without its advice.
std::string short_problem(const CaseResult& result) {
  const std::string& problem = result.problems.front();
  return problem.starts_with("stale") || problem.starts_with("no ") ? problem.substr(0, problem.find(':')) : problem;
}

std::string bits_text(const CaseResult& result) {
  const Outcome exact = result.verdict(VerdictKind::kExact).outcome;
  if (exact == Outcome::kPass) return "same bits";
  if (exact == Outcome::kNone) return "bits not judged";
  if (!result.difference) return "bits moved";
  const FirstDifference& difference = *result.difference;
  if (difference.phase == kSetup) {
    return "the engine was told otherwise" + (difference.details.empty() ? "" : ": " + difference.details.front());
  }
  const std::string size = difference.apart ? describe(*difference.apart) + ", " : "";
  const bool is_extra = difference.phase.starts_with("channel.") || difference.phase == "contacts";
  const std::string subject = is_extra ? difference.phase : "bits";
  const std::string told = difference.told.empty() ? "" : " (" + difference.told + ")";
  return size + subject + " moved from step " + std::to_string(difference.step) + told;
}

std::string metrics_text(const CaseResult& result) {
  const std::string total = count_text(result.metrics.size(), "metric");
  const auto failed = std::ranges::count_if(result.metrics, [](const MetricResult& m) { return !m.pass; });
  const Verdict& behaviour = result.verdict(VerdictKind::kBehaviour);
  if (behaviour.outcome == Outcome::kNone) return "metrics not judged";
  if (behaviour.outcome == Outcome::kFail && failed == 0) return behaviour.message;
  if (failed > 0) {
    const auto first = std::ranges::find(result.metrics, false, &MetricResult::pass);
    return std::to_string(failed) + " of " + total + " failed: " + movement_text(*first) + ", " + first->message;
  }
  const MetricResult* most = most_moved(result.metrics);
  if (most == nullptr) return total + " unmoved";
  return std::to_string(moved_metrics(result)) + " of " + total + " moved within bounds, most: " + movement_text(*most);
}

std::string pictures_text(const CaseResult& result) {
  const Outcome image = result.verdict(VerdictKind::kImage).outcome;
  const bool is_required = std::ranges::find(result.require, VerdictKind::kImage) != result.require.end();
  if (image == Outcome::kNone) return is_required ? "no picture to judge, and an image verdict is required" : "";
  const auto moved =
      std::ranges::count_if(result.pictures, [](const PictureResult& p) { return !p.pass || p.pixels > 0; });
  if (image == Outcome::kFail) return "pictures changed";
  return moved == 0
             ? "same pictures"
             : std::to_string(moved) + " of " + count_text(result.pictures.size(), "picture") + " moved within bounds";
}

/// Of several runs: whether they agree or by how much they differ, without what was compared, which JSON and page have.
std::string shortly(const std::string& runs_message) {
  const std::string text = runs_message.substr(0, runs_message.find(';'));
  constexpr std::string_view kCompared = " compared (";
  const std::size_t compared = text.find(kCompared);
  return compared == std::string::npos ? text : text.substr(0, compared + kCompared.size() - 2);
}

}  // namespace

const char* to_string(Change change) {
  constexpr std::array kWords = {"unchanged", "moved within bounds", "out of bounds", "not judged"};
  return kWords[static_cast<std::size_t>(change)];
}

const char* key_of(Change change) {
  constexpr std::array kKeys = {"unchanged", "within_bounds", "out_of_bounds", "not_judged"};
  return kKeys[static_cast<std::size_t>(change)];
}

bool has_moved(const MetricResult& metric) {
  if (metric.rule.is_law) return false;  // it has no blessed value
  if (metric.spread && metric.value && metric.rule.value) {
    return std::fabs(*metric.value - *metric.rule.value) > *metric.spread;
  }
  return !replay::same_value(metric.value, metric.rule.value);
}

std::size_t moved_metrics(const CaseResult& result) {
  return static_cast<std::size_t>(std::ranges::count_if(result.metrics, has_moved));
}

const MetricResult* most_moved(const std::vector<MetricResult>& metrics) {
  const MetricResult* most = nullptr;
  for (const MetricResult& metric : metrics) {
    if (!has_moved(metric)) continue;
    if (most == nullptr || relative_movement(metric) > relative_movement(*most)) most = &metric;
  }
  return most;
}

std::string value_text(const std::optional<double>& value, const std::string& unit) {
  if (value && !std::isfinite(*value)) return std::isnan(*value) ? "not a number" : "infinite";
  return value ? rounded(*value, unit) : "null";
}

std::string movement_text(const MetricResult& metric) {
  const auto text = [&](int digits) {
    return std::pair(with_unit(metric.rule.value, digits, metric.unit), with_unit(metric.value, digits, metric.unit));
  };
  if (!has_moved(metric)) return metric.rule.name + ' ' + text(kDigits).second;
  int digits = kDigits;
  while (digits < kDigitsMax && text(digits).first == text(digits).second) ++digits;
  const auto [before, after] = text(digits);
  return metric.rule.name + ' ' + before + " → " + after;
}

bool differs_from_golden_alone(const MetricResult& metric) {
  if (metric.pass || metric.rule.is_law || metric.spread || !metric.rule.value || !metric.value) return false;
  const double value = *metric.value;
  return std::isfinite(value) && !(metric.rule.max && value > *metric.rule.max) &&
         !(metric.rule.min && value < *metric.rule.min);
}

Change change_of(const CaseResult& result) {
  const Outcome exact = result.verdict(VerdictKind::kExact).outcome;
  const Outcome behaviour = result.verdict(VerdictKind::kBehaviour).outcome;
  const Outcome image = result.verdict(VerdictKind::kImage).outcome;
  const auto within = [](const MetricResult& m) { return m.pass || differs_from_golden_alone(m); };
  const bool beyond = behaviour == Outcome::kFail && (std::ranges::all_of(result.metrics, &MetricResult::pass) ||
                                                      !std::ranges::all_of(result.metrics, within));
  if (beyond || image == Outcome::kFail) return Change::kOutOfBounds;
  if (exact == Outcome::kNone || behaviour == Outcome::kNone) return Change::kNotJudged;
  const bool pixels = std::ranges::any_of(result.pictures, [](const PictureResult& p) { return p.pixels > 0; });
  const bool moved = exact == Outcome::kFail || moved_metrics(result) > 0 || pixels;
  return moved ? Change::kWithinBounds : Change::kNone;
}

std::string summary(const CaseResult& result) {
  const Outcome exact = result.verdict(VerdictKind::kExact).outcome;
  const Outcome behaviour = result.verdict(VerdictKind::kBehaviour).outcome;
  if (exact == Outcome::kNone && behaviour == Outcome::kNone) {
    return result.problems.empty() ? "nothing was judged" : result.problems.front();
  }
  // Of two parts that say little ("same bits") the failed one comes first.
  const bool bits_last = exact != Outcome::kFail && behaviour == Outcome::kFail;
  std::string text = bits_last ? metrics_text(result) : bits_text(result);
  text +=
      (exact == Outcome::kPass && !bits_last ? ", " : "; ") + (bits_last ? bits_text(result) : metrics_text(result));
  if (const std::string pictures = pictures_text(result); !pictures.empty()) text += ", " + pictures;
  if (!result.runs_message.empty()) text += "; " + shortly(result.runs_message);
  if (!result.gone_on.empty()) text += "; " + result.gone_on;
  if (!result.problems.empty()) text += "; " + short_problem(result);
  return text;
}

}  // namespace tumble::golden
