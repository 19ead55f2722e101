#include "replay/view/bound_scan.h"

#include <utility>

namespace tumble::replay {

BoundScan::BoundScan(const LogHeader& header, std::vector<MetricBound> bounds)
    : axes_(header.axes()), bounds_(std::move(bounds)), measurer_(header) {}

std::vector<BoundState> BoundScan::add(const StepRecord& record) {
  if (bounds_.empty()) return {};
  measurer_.add(record);
  Measurer up_to_here = measurer_;  // finish() ends a measurement, and this one goes on
  const Result<Metrics> metrics = up_to_here.finish(record.states);
  if (!metrics.ok() || !check_measured(*metrics).ok()) return {};
  std::vector<BoundState> states;
  for (const MetricBound& bound : bounds_) {
    const std::optional<double> value = bound.metric->value_in(axes_, *metrics);
    states.push_back({value, bound.holds(value)});
  }
  return states;
}

}  // namespace tumble::replay
