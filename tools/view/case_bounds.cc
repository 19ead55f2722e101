#include "tools/view/case_bounds.h"

#include <utility>

#include "golden/suite/metric_values.h"
#include "golden/suite/parse_rules.h"
#include "src/base/text.h"

namespace tumble::tools {
namespace {

using Comparison = replay::MetricBound::Comparison;

// "drift_max of 2 from step 60 <= 0.1", as the metric and its choice are called in metrics.toml.
std::string bound_text(const golden::MetricRule& rule, const char* comparison, double limit) {
  std::string text = rule.name;
  if (rule.bodies != "all") text += " of " + rule.bodies;
  if (rule.axis != "x") text += " along " + rule.axis;
  if (rule.from_step > 0) text += " from step " + std::to_string(rule.from_step);
  return text + ' ' + comparison + ' ' + number_text(limit);
}

}  // namespace

Result<CaseBounds> bounds_of_case(const std::string& file, const replay::EngineAxes& axes,
                                  const replay::BodyTable& named) {
  const Result<golden::CaseRules> rules = golden::read_rules(file);
  if (!rules.ok()) return rules.error();
  CaseBounds found;
  for (const golden::MetricRule& rule : rules->metrics) {
    const replay::MetricRow* metric = replay::find_metric(rule.name);
    const bool of_scene = golden::needs_transformed_scene(rule);
    if (of_scene || metric->needs_other_session()) {
      found.notes.push_back(printable(file) + ": " + printable(rule.name) + " compares with " +
                            (of_scene ? "a transformed scene" : "another session") +
                            " and has no value step by step; tumble check judges it");
      continue;
    }
    const Result<replay::MeasureOptions> options = golden::options_of(rule, axes, named);
    if (!options.ok()) return options.error();
    const auto add = [&](Comparison comparison, const char* sign, double metres) {
      const double limit = metric->is_length() ? axes.their_metres(metres) : metres;
      found.bounds.push_back({{metric, comparison, limit, bound_text(rule, sign, limit)}, *options, rule.may_be_null});
    };
    if (rule.min) add(Comparison::kAtLeast, ">=", *rule.min);
    if (rule.max) add(Comparison::kAtMost, "<=", *rule.max);
  }
  return found;
}

}  // namespace tumble::tools
