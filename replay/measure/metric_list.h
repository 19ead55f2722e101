#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "replay/measure/measure.h"

namespace tumble::replay {

/// One metric: its name is the same word in this table, in `measure --json`, in docs/metrics.md and in a case's
/// metrics.toml. Adding a metric means a row here, its formula there and its value in Metrics.
struct MetricRow {
  const char* name;
  const char* label;    ///< for people
  const char* unit;     ///< "m", "J", "s", "degrees", "bodies", "bounces"; "" for ratios
  const char* group;    ///< "symmetry", "energy", "stacking"
  const char* nothing;  ///< what it means for people that there is no value
  std::optional<double> (*value)(const Metrics& metrics);

  /// A number of things, to be written without a point.
  [[nodiscard]] bool counts() const {
    return unit == std::string_view("bodies") || unit == std::string_view("bounces");
  }
};

/// All metrics, those of a group together.
std::span<const MetricRow> metric_list();

/// Null if there is none of that name.
const MetricRow* find_metric(std::string_view name);

}  // namespace tumble::replay
