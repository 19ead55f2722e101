#include "golden/judge/judge_metrics.h"

#include <algorithm>
#include <cmath>

#include "golden/suite/metric_values.h"
#include "src/base/check.h"
#include "src/base/text.h"

namespace tumble::golden {
namespace {

/// Metrics use the C library's trigonometry, whose last bits vary from machine to machine.
constexpr double kSameValue = 1e-9;

bool is_same(double a, double b) { return std::fabs(a - b) <= kSameValue * std::max(std::fabs(a), std::fabs(b)); }

std::string beyond(const char* side, double value, double bound, const std::string& unit) {
  return std::string(side) + " the bound by " + rounded(std::fabs(value - bound), unit);
}

/// The fault of a value; empty if it has none.
std::string fault_of(const MetricRule& rule, const std::optional<double>& value, const std::string& unit,
                     bool same_bits) {
  if (!value) {
    if (rule.may_be_null) return "";
    return "null: the question makes no sense for this session (may_be_null = true allows that)";
  }
  if (!std::isfinite(*value)) return *value != *value ? "not a number" : "infinite";
  if (rule.max && !(*value <= *rule.max)) return beyond("above", *value, *rule.max, unit);
  if (rule.min && !(*value >= *rule.min)) return beyond("below", *value, *rule.min, unit);
  if (!rule.value && !rule.may_be_null) return "no value yet: bless the case";
  const bool same = rule.value && is_same(*value, *rule.value);
  if (same_bits && !same) return "another value although no bit moved: the measuring changed";
  return "";
}

std::string movement_of(const MetricRule& rule, const std::optional<double>& value, const std::string& unit) {
  if (!value || !std::isfinite(*value) || !rule.value || is_same(*value, *rule.value)) return "";
  return "moved by " + rounded(*value - *rule.value, unit);
}

}  // namespace

Verdict judge_metrics(const CaseRules& rules, const std::vector<std::optional<double>>& values, bool same_bits,
                      std::vector<MetricResult>& out) {
  SIM_CHECK(values.size() == rules.metrics.size(), values.size(), rules.metrics.size());
  std::size_t failed = 0;
  std::size_t moved = 0;
  for (std::size_t k = 0; k < rules.metrics.size(); ++k) {
    MetricResult metric;
    metric.rule = rules.metrics[k];
    metric.unit = metric_unit(metric.rule.name);
    metric.value = values[k];
    const std::string fault = fault_of(metric.rule, metric.value, metric.unit, same_bits);
    const std::string movement = movement_of(metric.rule, metric.value, metric.unit);
    metric.pass = fault.empty();
    metric.message = metric.pass ? movement : fault;
    failed += metric.pass ? 0U : 1U;
    moved += movement.empty() ? 0U : 1U;
    out.push_back(std::move(metric));
  }
  const std::string total = std::to_string(rules.metrics.size());
  if (rules.metrics.empty()) return {Outcome::kFail, "no metric: nothing to compare"};
  if (failed > 0) return {Outcome::kFail, std::to_string(failed) + " of " + total + " metrics failed"};
  std::string words = "all " + total + " metrics within bounds";
  if (moved > 0) words += ", " + std::to_string(moved) + " moved";
  return {Outcome::kPass, words};
}

}  // namespace tumble::golden
