#include "replay/measure/metric_list.h"

#include <algorithm>
#include <cmath>

namespace tumble::replay {
namespace {

using Value = std::optional<double>;

constexpr MetricRow kMetrics[] = {
    {"lateral_max", "lateral error, largest", "m", "symmetry", "",
     [](const Metrics& m) -> Value { return m.symmetry.lateral_max; }},
    {"lateral_rms", "lateral error, rms", "m", "symmetry", "",
     [](const Metrics& m) -> Value { return m.symmetry.lateral_rms; }},
    {"column_spread", "column spread", "m", "symmetry", "no grid",
     [](const Metrics& m) { return m.symmetry.column_spread; }},
    {"mirror_error", "mirror error", "m", "symmetry", "no mirrored pair",
     [](const Metrics& m) { return m.symmetry.mirror_error; }, true},
    {"order_error", "order error", "m", "symmetry", "no mirrored pair",
     [](const Metrics& m) { return m.symmetry.order_error; }, true},
    {"shift_error", "shift error", "m", "symmetry", "no mirrored pair",
     [](const Metrics& m) { return m.symmetry.shift_error; }, true},

    {"initial", "at the start", "J", "energy", "", [](const Metrics& m) -> Value { return m.energy.initial; }, true},
    {"final", "at the end", "J", "energy", "", [](const Metrics& m) -> Value { return m.energy.final; }, true},
    {"gain_max", "largest gain", "J", "energy", "", [](const Metrics& m) -> Value { return m.energy.gain_max; }, true},
    {"gain_ratio", "largest gain, of the start's", "", "energy", "gained from nothing",
     [](const Metrics& m) { return m.energy.gain_ratio; }, true},
    {"removed", "removed", "J", "energy", "", [](const Metrics& m) -> Value { return m.energy.removed; }, true},
    {"inputs", "put in by inputs", "J", "energy", "", [](const Metrics& m) -> Value { return m.energy.inputs; }, true},
    {"bounce_height_loss", "change of bounce height", "", "energy", "no bounce",
     [](const Metrics& m) { return m.energy.bounce_height_loss; }},
    {"bounces", "bounces", "bounces", "energy", "",
     [](const Metrics& m) -> Value { return static_cast<double>(m.energy.bounces); }},
    {"momentum_drift", "angular momentum, drift", "", "energy", "no spin",
     [](const Metrics& m) { return m.energy.momentum_drift; }},
    {"spin_energy_gain", "rotational energy, gain", "", "energy", "no spin",
     [](const Metrics& m) { return m.energy.spin_energy_gain; }},

    {"drift_max", "drift, largest", "m", "stacking", "",
     [](const Metrics& m) -> Value { return m.stacking.drift_max; }},
    {"tilt_max", "tilt, largest", "degrees", "stacking", "",
     [](const Metrics& m) -> Value { return m.stacking.tilt_max; }},
    {"top_drop_max", "drop, largest", "m", "stacking", "",
     [](const Metrics& m) -> Value { return m.stacking.top_drop_max; }},
    {"lost", "bodies lost", "bodies", "stacking", "",
     [](const Metrics& m) -> Value { return static_cast<double>(m.stacking.lost); }},
    {"overlap_max", "deepest overlap at the end", "m", "stacking", "",
     [](const Metrics& m) -> Value { return m.stacking.overlap_max; }, true},
    {"overlap_peak", "deepest overlap", "m", "stacking", "",
     [](const Metrics& m) -> Value { return m.stacking.overlap_peak; }, true},
    {"ground_penetration_max", "in the ground at the end", "m", "stacking", "",
     [](const Metrics& m) -> Value { return m.stacking.ground_penetration_max; }},
    {"ground_penetration_peak", "deepest in the ground", "m", "stacking", "",
     [](const Metrics& m) -> Value { return m.stacking.ground_penetration_peak; }},
    {"kinetic_end", "kinetic energy left", "J", "stacking", "",
     [](const Metrics& m) -> Value { return m.stacking.kinetic_end(); }},
    {"kinetic_linear_end", "  linear", "J", "stacking", "",
     [](const Metrics& m) -> Value { return m.stacking.kinetic_linear_end; }},
    {"kinetic_rotational_end", "  rotational", "J", "stacking", "",
     [](const Metrics& m) -> Value { return m.stacking.kinetic_rotational_end; }},
    {"frozen_fraction", "frozen at the end, fraction", "", "stacking", "",
     [](const Metrics& m) -> Value { return m.stacking.frozen_fraction; }},
    {"rest_time", "at rest from", "s", "stacking", "never", [](const Metrics& m) { return m.stacking.rest_time; }},
};

}  // namespace

std::optional<double> MetricRow::value(const Metrics& metrics) const {
  return spoiled_by(metrics) ? kNotANumber : counted(metrics);
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
  return row == std::end(kMetrics) ? nullptr : row;
}

}  // namespace tumble::replay
