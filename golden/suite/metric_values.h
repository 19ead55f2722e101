#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "replay/measure/measure.h"
#include "replay/measure/parting.h"
#include "tumble/golden/case_rules.h"
#include "tumble/replay/step_record.h"

/// The metrics of replay/measure/metric_list.h for the rules of a case.
namespace tumble::golden {

/// All names, in the order of docs/metrics.md.
std::vector<const char*> metric_names();
std::string metric_unit(const std::string& name);

/// Errors (kBadInput): bodies that are not written as docs/metrics.md says.
Status check_selection(const MetricRule& rule);

/// The bodies, axis and steps of a rule. axes and names: of the session. Errors (kBadInput), each with the line of the
/// rule: an axis that is not horizontal in the engine's own axes, a body that the session has not.
Result<replay::MeasureOptions> options_of(const MetricRule& rule, const replay::EngineAxes& axes,
                                          const replay::BodyTable& named);

/// Whether the metric compares the session with one of a transformed scene.
bool needs_transformed_scene(const MetricRule& rule);

/// Measures all metrics of a case in one pass over its session. Metrics of a session and its transformed scene
/// (mirror_error along the rule's axis, order_error, shift_error) run the scene twice more, at the end.
class MetricSet {
 public:
  /// header and rules, of the session, must outlive this.
  MetricSet(const replay::LogHeader& header, const CaseRules& rules);

  /// State 0, then every step in order, with states.
  void add(const replay::StepRecord& record);

  /// After the last step: a value a rule, none where the metric makes no sense. last: the last state. Errors: a rule
  /// that measures nothing, such as one from a step that the session does not reach (kBadInput); a transformed
  /// scene that cannot be run (run_mirrored_pair's).
  Result<std::vector<std::optional<double>>> finish(const replay::BodyStates& last);

 private:
  [[nodiscard]] Result<std::optional<double>> pair_value(const MetricRule& rule) const;
  Status open_others();
  [[nodiscard]] std::optional<double> value_of(const MetricRule& rule, const replay::Metrics& metrics) const;

  /// Another session, and the meters of the rules that compare with it.
  struct Other {
    std::unique_ptr<replay::LogReader> log;
    std::unique_ptr<replay::PartingMeter> meter;
  };

  const replay::LogHeader& header_;
  const CaseRules& rules_;
  std::vector<replay::Measurer> measurers_;  // one for each choice of bodies, axis and step
  std::vector<std::size_t> of_rule_;         // index into measurers_
  std::map<std::string, Other> others_;      // by path
  Status choices_;                           // the first rule whose axis or bodies the session has not
  Status others_read_;                       // the first error of theirs
};

}  // namespace tumble::golden
