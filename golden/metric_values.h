#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "golden/case_rules.h"
#include "replay/measure.h"
#include "replay/step_record.h"

/// The metrics of replay/measure.h by the names that metrics.toml uses.
namespace tumble::golden {

/// All names, in the order of docs/metrics.md.
std::vector<const char*> metric_names();
std::string metric_unit(const std::string& name);

/// Errors (kBadInput): bodies or an axis that no metric can be measured over.
Status check_selection(const MetricRule& rule);

/// Measures all metrics of a case in one pass over its session.
class MetricSet {
 public:
  /// header, rules: of the session, must outlive this.
  MetricSet(const replay::LogHeader& header, const CaseRules& rules);
  ~MetricSet();

  /// State 0, then every step in order, with states.
  void add(const replay::StepRecord& record);

  /// After the last step: a value a rule, none where the metric makes no sense. last: the last state. Errors
  /// (kBadInput): a rule that measures nothing, such as one from a step that the session does not reach.
  Result<std::vector<std::optional<double>>> finish(const replay::BodyStates& last);

 private:
  struct Selected;
  const replay::LogHeader& header_;
  const CaseRules& rules_;
  std::vector<std::unique_ptr<Selected>> measurers_;  // one for each choice of bodies, axis and step
  std::vector<std::size_t> of_rule_;                  // index into measurers_
};

}  // namespace tumble::golden
