#include "replay/view/bound_scan.h"

#include <algorithm>
#include <utility>

namespace tumble::replay {
namespace {

bool same_choice(const MeasureOptions& a, const MeasureOptions& b) {
  return a.bodies == b.bodies && a.lateral == b.lateral && a.from_step == b.from_step;
}

}  // namespace

BoundScan::BoundScan(const LogHeader& header, std::vector<ViewedBound> bounds)
    : axes_(header.axes()), bounds_(std::move(bounds)) {
  std::vector<const MeasureOptions*> choices;
  for (const ViewedBound& bound : bounds_) {
    const auto known =
        std::ranges::find_if(choices, [&](const MeasureOptions* one) { return same_choice(*one, bound.options); });
    of_bound_.push_back(static_cast<std::size_t>(known - choices.begin()));
    if (known != choices.end()) continue;
    choices.push_back(&bound.options);
    measurers_.emplace_back(header, bound.options);
  }
}

std::vector<BoundState> BoundScan::add(const StepRecord& record) {
  std::vector<std::optional<Metrics>> measured;
  for (Measurer& measurer : measurers_) {
    measurer.add(record);
    Measurer up_to_here = measurer;  // finish() ends a measurement, and this one goes on
    const Result<Metrics> metrics = up_to_here.finish(record.states);
    measured.emplace_back();
    if (metrics.ok() && check_measured(*metrics).ok()) measured.back() = *metrics;
  }
  std::vector<BoundState> states;
  for (std::size_t k = 0; k < bounds_.size(); ++k) {
    const std::optional<Metrics>& metrics = measured[of_bound_[k]];
    if (!metrics) {
      states.push_back({std::nullopt, false, false});
      continue;
    }
    const MetricBound& bound = bounds_[k].bound;
    const std::optional<double> value = bound.metric->value_in(axes_, *metrics);
    states.push_back({value, bound.holds(value) || (!value && bounds_[k].may_be_null), true});
  }
  return states;
}

}  // namespace tumble::replay
