#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "replay/measure/measure.h"
#include "replay/measure/measure_options.h"
#include "replay/measure/metric_bound.h"
#include "tumble/replay/step_record.h"

namespace tumble::replay {

/// A bound, and the bodies, axis and steps that it is about.
struct ViewedBound {
  MetricBound bound;  ///< its text is shown
  MeasureOptions options = {};
  bool may_be_null = false;  ///< a metric without a value is within the bound
};

/// One bound on the session up to a step, as `measure --require` would judge a log that ends there.
struct BoundState {
  std::optional<double> value;  ///< of the metric, in the unit of the session's table; none: it has no value
  bool holds = false;
  bool judged = true;  ///< false: what the bound is about has not begun, or none of its bodies exists
};

/// Judges bounds on a session after each of its steps, so that the step in which one breaks can be shown.
class BoundScan {
 public:
  BoundScan(const LogHeader& header, std::vector<ViewedBound> bounds);

  /// Takes the record of the first state, then those of the steps that follow, with states. The states of the bounds,
  /// in their order; empty where there is none.
  std::vector<BoundState> add(const StepRecord& record);

 private:
  EngineAxes axes_;
  std::vector<ViewedBound> bounds_;
  std::vector<Measurer> measurers_;    // one for each choice of bodies, axis and steps
  std::vector<std::size_t> of_bound_;  // index into measurers_
};

}  // namespace tumble::replay
