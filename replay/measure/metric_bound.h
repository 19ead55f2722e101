#pragma once

#include <optional>
#include <string>

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
};

/// Reads NAME, one of < <= > >=, and a number, with or without spaces between. Errors (kBadInput): any other text; a
/// name that no metric has.
Result<MetricBound> parse_metric_bound(const std::string& text);

}  // namespace tumble::replay
