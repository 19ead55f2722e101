#include "golden/run/obstacle.h"

#include <algorithm>

#include "src/base/text.h"

namespace tumble::golden {
namespace {

/// Why a value may not become a golden: it is out of its bounds, or null where that is not allowed. Empty: it may.
std::string fault_of_value(const MetricResult& metric) {
  const MetricRule& rule = metric.rule;
  const bool above = metric.value && rule.max && !(*metric.value <= *rule.max);
  const bool below = metric.value && rule.min && !(*metric.value >= *rule.min);
  const bool null = !metric.value && !rule.may_be_null;
  if (!above && !below && !null) return "";
  const std::string bound = above   ? ", above its max of " + rounded(*rule.max, metric.unit)
                            : below ? ", below its min of " + rounded(*rule.min, metric.unit)
                                    : "";
  return rule.name + " is " + (metric.value ? rounded(*metric.value, metric.unit) : "null") + bound;
}

}  // namespace

std::string obstacle_to_bless(const CaseRun& run, const std::filesystem::path& rules) {
  const CaseResult& result = run.result;
  if (!run.complete) return result.problems.empty() ? "it did not run to its end" : result.problems.front();
  for (const std::string& problem : result.problems) {
    if (problem.starts_with("unreferenced") || problem.starts_with("not finite")) return problem;
  }
  for (std::size_t k = 0; k < run.pictures.size(); ++k) {
    if (run.pictures[k].png.empty()) return result.pictures[k].rule.file() + " " + result.pictures[k].message;
  }
  for (const MetricResult& metric : result.metrics) {
    const std::string fault = fault_of_value(metric);
    if (!fault.empty()) {
      return fault + "; if that is right, change the bound and its reason in " + rules.string() + " first";
    }
  }
  if (std::ranges::all_of(result.metrics, [](const MetricResult& m) { return !m.value; })) {
    return "every metric reads null, so that nothing would be judged; give " + rules.string() + " one that has a value";
  }
  return "";
}

}  // namespace tumble::golden
