#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "replay/format/not_finite.h"
#include "replay/measure/measure.h"
#include "tumble/replay/imported_table.h"

namespace tumble::replay {

/// One metric. Its name is one word in this table, in `measure --json`, in docs/metrics.md and in a case's
/// metrics.toml. A new metric needs a row here, its formula in docs/metrics.md and its value in Metrics.
struct MetricRow {
  const char* name;
  const char* label;    ///< for people
  const char* unit;     ///< "m", "J", "s", "degrees", "bodies", "bounces"; "" for ratios
  const char* group;    ///< "symmetry", "energy", "stacking"
  const char* nothing;  ///< shown to people in place of a missing value; "" for a metric that always has one
  std::optional<double> (*counted)(const Metrics& metrics);  ///< over the bodies that are finite
  bool over_all = false;                                     ///< over all bodies of the world, chosen or not
  double low = -std::numeric_limits<double>::infinity();     ///< the least value that there can be
  double high = std::numeric_limits<double>::infinity();     ///< the largest
  const char* channel = nullptr;                             ///< the name of a channel, whose metric this is
  ChannelStatistic statistic = ChannelStatistic::kMax;       ///< of that channel
  double beyond = 0;                                         ///< m, of parting_time; 0: another metric

  /// The value. NaN where a body that belongs to the metric is lost because it is not finite.
  [[nodiscard]] std::optional<double> value(const Metrics& metrics) const;
  /// value() in the unit of length of the session's table, and the name of that unit.
  [[nodiscard]] std::optional<double> value_in(const EngineAxes& axes, const Metrics& metrics) const;
  [[nodiscard]] std::string unit_in(const EngineAxes& axes) const { return is_length() ? axes.unit() : unit; }
  /// The lost body that takes the value from this metric; none: it has its value.
  [[nodiscard]] const std::optional<NotFinite>& spoiled_by(const Metrics& metrics) const;

  /// Whether the metric compares the session with another one, which a caller has to name (parting.h).
  [[nodiscard]] bool needs_other_session() const { return beyond > 0; }
  [[nodiscard]] bool is_length() const { return unit == std::string_view("m"); }
  /// Whether the metric is a count, written without a decimal point.
  [[nodiscard]] bool counts() const {
    return unit == std::string_view("bodies") || unit == std::string_view("bounces");
  }
};

/// Whether two values of a metric are equal to 1e-9 of the larger one: the C library's trigonometry varies below that,
/// and any change that matters lies far above. NaN equals NaN, and no value equals no value.
bool same_value(const std::optional<double>& a, const std::optional<double>& b);

/// All metrics, those of a group together.
std::span<const MetricRow> metric_list();

/// The metric of that name; null if there is none. "channel.NAME.max" and the like name metrics of channels, of a log
/// that has such a channel or of none; see channel_metrics.h. "parting_time.0.01": see parting.h.
const MetricRow* find_metric(std::string_view name);

}  // namespace tumble::replay
