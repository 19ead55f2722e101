#include "golden/judge/judge_metrics.h"

#include <algorithm>
#include <cmath>

#include "golden/suite/metric_values.h"
#include "replay/measure/metric_list.h"
#include "src/base/check.h"
#include "src/base/text.h"
#include "tumble/golden/change.h"

namespace tumble::golden {
namespace {

std::string beyond(const char* side, double value, double bound, const std::string& unit) {
  return std::string(side) + " the bound by " + rounded(std::fabs(value - bound), unit);
}

/// The fault of a value, compared with the blessed one as well; empty if it has none.
std::string fault_of(const MetricRule& rule, const std::optional<double>& value, const std::string& unit,
                     bool same_bits) {
  if (!value && rule.value && same_bits)
    return "null, and the golden has a value, though no bit moved: the golden was edited, or measured "
           "by another version";
  if (std::string fault = fault_of_value(rule, value, unit); !fault.empty() || !value) return fault;
  if (!rule.value && !rule.may_be_null) return "no value yet: bless the case";
  const bool same = replay::same_value(value, rule.value);
  if (same_bits && !same)
    return "within its bound, but not the golden's value though no bit moved: the golden was edited, or measured by "
           "another version; bless the case";
  return "";
}

std::string movement_of(const MetricResult& metric) {
  if (!has_moved(metric)) return "";
  if (!metric.value || !metric.rule.value) return "moved: " + movement_text(metric);
  return "moved by " + rounded(*metric.value - *metric.rule.value, metric.unit);
}

/// The words for metrics that all passed. A metric that reads null was allowed to and judged nothing.
Verdict passed(const std::vector<MetricResult>& metrics) {
  const auto null = std::ranges::count_if(metrics, [](const MetricResult& m) { return !m.value; });
  const auto moved = std::ranges::count_if(metrics, has_moved);
  const auto total = std::ssize(metrics);
  if (null == total) return {Outcome::kFail, "nothing was judged: every metric reads null"};
  std::string words = count_text(static_cast<std::uint64_t>(total - null), "metric") + " within bounds";
  if (null > 0) words += ", " + std::to_string(null) + " more null and not judged";
  const MetricResult* most = most_moved(metrics);
  if (most == nullptr) return {Outcome::kPass, words + ", none moved"};
  return {Outcome::kPass, words + ", " + std::to_string(moved) + " moved, most: " + movement_text(*most)};
}

}  // namespace

std::string fault_of_value(const MetricRule& rule, const std::optional<double>& value, const std::string& unit) {
  if (!value) {
    if (rule.may_be_null) return "";
    return "null: the question makes no sense for this session (may_be_null = true allows that)";
  }
  if (!std::isfinite(*value)) return *value != *value ? "not a number" : "infinite";
  if (rule.max && !(*value <= *rule.max)) return beyond("above", *value, *rule.max, unit);
  if (rule.min && !(*value >= *rule.min)) return beyond("below", *value, *rule.min, unit);
  return "";
}

Verdict judge_metrics(const CaseRules& rules, const std::vector<std::optional<double>>& values, bool same_bits,
                      std::vector<MetricResult>& out) {
  SIM_CHECK(values.size() == rules.metrics.size(), values.size(), rules.metrics.size());
  for (std::size_t k = 0; k < rules.metrics.size(); ++k) {
    MetricResult metric;
    metric.rule = rules.metrics[k];
    metric.unit = metric_unit(metric.rule.name);
    metric.value = values[k];
    const std::string fault = fault_of(metric.rule, metric.value, metric.unit, same_bits);
    metric.pass = fault.empty();
    metric.message = metric.pass ? movement_of(metric) : fault;
    out.push_back(std::move(metric));
  }
  if (rules.metrics.empty()) return {Outcome::kFail, "no metric: nothing to compare"};
  const auto failed = std::ranges::count_if(out, [](const MetricResult& m) { return !m.pass; });
  if (failed == 0) return passed(out);
  return {Outcome::kFail, std::to_string(failed) + " of " + count_text(rules.metrics.size(), "metric") + " failed"};
}

}  // namespace tumble::golden
