#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "replay/measure/measure.h"
#include "replay/measure/metric_bound.h"
#include "tumble/replay/step_record.h"

namespace tumble::replay {

/// One bound on the session up to a step, as `measure --require` would judge a log that ends there.
struct BoundState {
  std::optional<double> value;  ///< of the metric, in the unit of the session's table; none: it has no value
  bool holds = false;
};

/// Judges bounds on a session after each of its steps, so that the step in which one breaks can be shown.
class BoundScan {
 public:
  BoundScan(const LogHeader& header, std::vector<MetricBound> bounds);

  /// Takes the record of the first state, then those of the steps that follow, with states. The states of the bounds,
  /// in their order; empty where the session measured has no step yet.
  std::vector<BoundState> add(const StepRecord& record);

 private:
  EngineAxes axes_;
  std::vector<MetricBound> bounds_;
  Measurer measurer_;
};

}  // namespace tumble::replay
