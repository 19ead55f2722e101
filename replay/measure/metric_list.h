#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "replay/measure/measure.h"

namespace tumble::replay {

/// One metric. Its name is one word in this table, in `measure --json`, in docs/metrics.md and in a case's
/// metrics.toml. A new metric needs a row here, its formula in docs/metrics.md and its value in Metrics.
struct MetricRow {
  const char* name;
  const char* label;    ///< for people
  const char* unit;     ///< "m", "J", "s", "degrees", "bodies", "bounces"; "" for ratios
  const char* group;    ///< "symmetry", "energy", "stacking"
  const char* nothing;  ///< shown to people in place of a missing value
  std::optional<double> (*value)(const Metrics& metrics);

  /// Whether the metric is a count, written without a decimal point.
  [[nodiscard]] bool counts() const {
    return unit == std::string_view("bodies") || unit == std::string_view("bounces");
  }
};

/// All metrics, those of a group together.
std::span<const MetricRow> metric_list();

/// The metric of that name; null if there is none.
const MetricRow* find_metric(std::string_view name);

}  // namespace tumble::replay
