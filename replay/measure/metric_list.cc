#include "replay/measure/metric_list.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace tumble::replay {
namespace {

using Value = std::optional<double>;
constexpr bool kOverChosen = false, kOverAll = true;  // bodies

// A value over no body would read 0 and stand for bodies that nothing judged.
Value at_end(const Metrics& m, double value) { return m.bodies_at_end > 0 ? Value(value) : std::nullopt; }
Value of_start(const Metrics& m, double value) { return m.of_start_at_end > 0 ? Value(value) : std::nullopt; }

constexpr const char* kNoBody = "no body at the end";
constexpr const char* kNoneOfStart = "no body of the start is left at the end";

constexpr MetricRow kMetrics[] = {
    {"lateral_max", "lateral error, largest", "m", "symmetry", kNoneOfStart,
     [](const Metrics& m) { return of_start(m, m.symmetry.lateral_max); }, kOverChosen, 0},
    {"lateral_rms", "lateral error, rms", "m", "symmetry", kNoneOfStart,
     [](const Metrics& m) { return of_start(m, m.symmetry.lateral_rms); }, kOverChosen, 0},
    {"column_spread", "column spread", "m", "symmetry", "no body of a grid",
     [](const Metrics& m) { return m.symmetry.column_spread; }},
    {"mirror_error", "mirror error", "m", "symmetry", "no mirrored pair",
     [](const Metrics& m) { return m.symmetry.mirror_error; }, kOverAll},
    {"order_error", "order error", "m", "symmetry", "no mirrored pair",
     [](const Metrics& m) { return m.symmetry.order_error; }, kOverAll},
    {"shift_error", "shift error", "m", "symmetry", "no mirrored pair",
     [](const Metrics& m) { return m.symmetry.shift_error; }, kOverAll},

    {"initial", "at the start", "J", "energy", "", [](const Metrics& m) -> Value { return m.energy.initial; },
     kOverAll},
    {"final", "at the end", "J", "energy", "", [](const Metrics& m) -> Value { return m.energy.final; }, kOverAll},
    {"gain_max", "largest gain", "J", "energy", "", [](const Metrics& m) -> Value { return m.energy.gain_max; },
     kOverAll, 0},
    {"gain_ratio", "largest gain, of the start's", "", "energy", "gained from nothing",
     [](const Metrics& m) { return m.energy.gain_ratio; }, kOverAll},
    {"removed", "removed", "J", "energy", "not told by another engine",
     [](const Metrics& m) { return m.energy.removed; }, kOverAll},
    {"inputs", "put in by inputs", "J", "energy", "", [](const Metrics& m) -> Value { return m.energy.inputs; },
     kOverAll},
    {"bounce_height_loss", "change of bounce height", "", "energy", "no bounce",
     [](const Metrics& m) { return m.energy.bounce_height_loss; }},
    {"bounces", "bounces", "bounces", "energy", "",
     [](const Metrics& m) -> Value { return static_cast<double>(m.energy.bounces); }, kOverChosen, 0},
    {"momentum_drift", "angular momentum, drift", "", "energy", "no spin",
     [](const Metrics& m) { return m.energy.momentum_drift; }},
    {"spin_energy_gain", "rotational energy, gain", "", "energy", "no spin",
     [](const Metrics& m) { return m.energy.spin_energy_gain; }},

    {"drift_max", "drift, largest", "m", "stacking", kNoneOfStart,
     [](const Metrics& m) { return of_start(m, m.stacking.drift_max); }, kOverChosen, 0},
    {"tilt_max", "tilt, largest", "degrees", "stacking", kNoneOfStart,
     [](const Metrics& m) { return of_start(m, m.stacking.tilt_max); }, kOverChosen, 0, 180},
    {"top_drop_max", "drop, largest", "m", "stacking", kNoneOfStart,
     [](const Metrics& m) { return of_start(m, m.stacking.top_drop_max); }, kOverChosen, 0},
    {"lost", "bodies lost", "bodies", "stacking", "",
     [](const Metrics& m) -> Value { return static_cast<double>(m.stacking.lost); }, kOverChosen, 0},
    {"overlap_max", "deepest overlap at the end", "m", "stacking", kNoBody,
     [](const Metrics& m) { return at_end(m, m.stacking.overlap_max); }, kOverAll, 0},
    {"overlap_peak", "deepest overlap", "m", "stacking", "",
     [](const Metrics& m) -> Value { return m.stacking.overlap_peak; }, kOverAll, 0},
    {"ground_penetration_max", "in the ground at the end", "m", "stacking", kNoBody,
     [](const Metrics& m) { return at_end(m, m.stacking.ground_penetration_max); }, kOverChosen, 0},
    {"ground_penetration_peak", "deepest in the ground", "m", "stacking", "",
     [](const Metrics& m) -> Value { return m.stacking.ground_penetration_peak; }, kOverChosen, 0},
    {"kinetic_end", "kinetic energy left", "J", "stacking", kNoBody,
     [](const Metrics& m) { return at_end(m, m.stacking.kinetic_end()); }, kOverChosen, 0},
    {"kinetic_linear_end", "  linear", "J", "stacking", kNoBody,
     [](const Metrics& m) { return at_end(m, m.stacking.kinetic_linear_end); }, kOverChosen, 0},
    {"kinetic_rotational_end", "  rotational", "J", "stacking", kNoBody,
     [](const Metrics& m) { return at_end(m, m.stacking.kinetic_rotational_end); }, kOverChosen, 0},
    {"frozen_fraction", "frozen at the end, fraction", "", "stacking", kNoBody,
     [](const Metrics& m) { return at_end(m, m.stacking.frozen_fraction); }, kOverChosen, 0, 1},
    {"rest_time", "at rest from", "s", "stacking", "never",
     [](const Metrics& m) { return m.bodies_at_end > 0 ? m.stacking.rest_time : std::nullopt; }},
};

MetricRow channel_row(const ChannelMetricName& parts) {
  MetricRow row = {"", "", "", "channels", "no value of this channel in the session", [](const Metrics&) -> Value {
                     return std::nullopt;
                   }};
  const bool counts = parts.statistic == ChannelStatistic::kChanges || parts.statistic == ChannelStatistic::kChangeMax;
  if (counts) row.low = 0;
  row.statistic = parts.statistic;
  return row;
}

MetricRow parting_row(double beyond) {
  MetricRow row = {
      "", "", "s", "parting", "no other session to compare with", [](const Metrics&) -> Value { return std::nullopt; }};
  row.low = 0;
  row.beyond = beyond;
  return row;
}

/// Rows of channels and distances are made as they are asked for, and kept: callers hold on to them like to those of
/// the table.
const MetricRow* made_row(std::string_view name) {
  const std::optional<ChannelMetricName> channel = parse_channel_metric(name);
  const std::optional<double> beyond = parse_parting_metric(name);
  if (!channel && !beyond) return nullptr;
  struct Kept {
    std::string name, channel;
    MetricRow row = {};
  };
  static std::mutex mutex;
  static std::map<std::string, std::unique_ptr<Kept>, std::less<>> kept;
  const std::lock_guard lock(mutex);
  if (const auto known = kept.find(name); known != kept.end()) return &known->second->row;
  auto made = std::make_unique<Kept>();
  made->name = name;
  made->row = channel ? channel_row(*channel) : parting_row(*beyond);
  made->row.name = made->row.label = made->name.c_str();
  if (channel) {
    made->channel = channel->channel;
    made->row.channel = made->channel.c_str();
  }
  return &kept.emplace(std::string(name), std::move(made)).first->second->row;
}

}  // namespace

const std::optional<NotFinite>& MetricRow::spoiled_by(const Metrics& metrics) const {
  static const std::optional<NotFinite> kNone;
  if (channel != nullptr || needs_other_session()) return kNone;
  return over_all ? metrics.not_finite.any : metrics.not_finite.chosen;
}

std::optional<double> MetricRow::value(const Metrics& metrics) const {
  if (needs_other_session()) {
    const auto parting = std::ranges::find(metrics.partings, beyond, &Parting::beyond);
    return parting == metrics.partings.end() ? std::nullopt : std::optional<double>(parting->time);
  }
  if (channel == nullptr) return spoiled_by(metrics) ? kNotANumber : counted(metrics);
  const std::string_view wanted(channel);
  const auto found =
      std::ranges::find_if(metrics.channels, [wanted](const ChannelMetrics& m) { return m.channel.name == wanted; });
  return found == metrics.channels.end() ? std::nullopt : found->value(statistic);
}

std::optional<double> MetricRow::value_in(const EngineAxes& axes, const Metrics& metrics) const {
  const std::optional<double> metres = value(metrics);
  return metres && is_length() ? axes.their_metres(*metres) : metres;
}

bool same_value(const std::optional<double>& a, const std::optional<double>& b) {
  constexpr double kSameValue = 1e-9;
  if (!a || !b) return a.has_value() == b.has_value();
  if (!std::isfinite(*a) || !std::isfinite(*b)) return *a == *b || (std::isnan(*a) && std::isnan(*b));
  return std::fabs(*a - *b) <= kSameValue * std::max(std::fabs(*a), std::fabs(*b));
}

std::span<const MetricRow> metric_list() { return kMetrics; }

const MetricRow* find_metric(std::string_view name) {
  const auto* const row =
      std::ranges::find(kMetrics, name, [](const MetricRow& metric) { return std::string_view(metric.name); });
  return row == std::end(kMetrics) ? made_row(name) : row;
}

}  // namespace tumble::replay
