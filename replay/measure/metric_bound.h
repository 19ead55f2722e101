#pragma once

#include <optional>
#include <string>

#include "replay/measure/metric_list.h"
#include "src/base/result.h"

namespace tumble::replay {

/// A question about a session that has yes or no for an answer: "lateral_max<=0".
struct MetricBound {
  enum class Comparison { kBelow, kAtMost, kAbove, kAtLeast };

  const MetricRow* metric = nullptr;
  Comparison comparison = Comparison::kAtMost;
  double bound = 0;
  std::string text;  ///< as it was written

  /// A metric without a value, or that is not a number, is within no bound.
  [[nodiscard]] bool holds(const std::optional<double>& value) const;
};

/// NAME, one of < <= > >=, a number; spaces between them are fine. Errors (kBadInput): anything else, a name that no
/// metric has.
Result<MetricBound> parse_metric_bound(const std::string& text);

}  // namespace tumble::replay
