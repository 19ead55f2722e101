#include "golden/run/obstacle.h"

#include <algorithm>

#include "golden/judge/judge_metrics.h"
#include "golden/run/repeated_runs.h"
#include "replay/log/told_values.h"
#include "tumble/golden/change.h"

namespace tumble::golden {

std::string obstacle_to_bless(const CaseRun& run, const std::filesystem::path& rules) {
  const CaseResult& result = run.result;
  if (!run.incomplete.empty()) return run.incomplete;
  for (const std::string& problem : result.problems) {
    if (problem.starts_with("unreferenced") || problem.starts_with("not finite") ||
        problem.starts_with(replay::kToldImpossible)) {
      return problem;
    }
  }
  const Verdict& exact = result.verdict(VerdictKind::kExact);
  const bool needs_bits = std::ranges::find(run.rules.require, VerdictKind::kExact) != run.rules.require.end();
  if (needs_bits && exact.message.starts_with(kDoesNotRepeat)) {
    return exact.message + "; " + rules.string() +
           " requires exact, so the next check would fail whatever is blessed: make the engine repeat, or require "
           "behaviour alone";
  }
  for (std::size_t k = 0; k < run.pictures.size(); ++k) {
    if (run.pictures[k].png.empty()) return result.pictures[k].rule.file() + " " + result.pictures[k].message;
  }
  for (const MetricResult& metric : result.metrics) {
    if (metric.rule.is_law && !metric.pass) {
      return metric.rule.name + ": " + metric.message + "; mend it, or take " + metric.rule.name +
             " out of [laws] in " + rules.string() + " first";
    }
    if (metric.rule.is_law) continue;
    const std::string fault = fault_of_value(metric.rule, metric.value, metric.unit);
    if (fault.empty()) continue;
    std::string words = metric.rule.name;
    words += metric.value ? " is " + value_text(metric.value, metric.unit) + ", " : ": ";
    words += fault + "; if that is right, change the bound and its reason in " + rules.string() + " first";
    return words;
  }
  if (std::ranges::all_of(result.metrics, [](const MetricResult& m) { return m.rule.is_law || !m.value; })) {
    return "every metric reads null, so that nothing would be judged; give " + rules.string() + " one that has a value";
  }
  return "";
}

}  // namespace tumble::golden
