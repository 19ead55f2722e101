#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "replay/measure/metric_list.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// A condition on one metric of a session: "lateral_max<=0".
struct MetricBound {
  enum class Comparison { kBelow, kAtMost, kAbove, kAtLeast };

  const MetricRow* metric = nullptr;
  Comparison comparison = Comparison::kAtMost;
  double bound = 0;
  std::string text;  ///< as it was written

  /// A metric without a value, or with one that is not finite, is within no bound.
  [[nodiscard]] bool holds(const std::optional<double>& value) const;

  /// The value of the metric in words, in the unit of the session's table: "0.1 m", "no value: no body of the start",
  /// "no number: body 2 is lost: …".
  [[nodiscard]] std::string found_text(const EngineAxes& axes, const Metrics& metrics) const;
};

/// Reads NAME, one of < <= > >=, and a finite number, with or without spaces between. Errors (kBadInput): any other
/// text; a name that no metric has; a bound that judges nothing.
Result<MetricBound> parse_metric_bound(const std::string& text);

/// Whether a metric of that name is within these inclusive bounds whatever happens: "lost at least 0", "frozen_fraction
/// at most 1". Such a bound judges nothing. A name that no metric has gives false.
bool judges_nothing(std::string_view name, const std::optional<double>& min, const std::optional<double>& max);

/// Bounds judge a session of at least one step with at least one body that can move. Errors (kBadInput): the session
/// measured has less.
Status check_measured(const Metrics& metrics);

}  // namespace tumble::replay
