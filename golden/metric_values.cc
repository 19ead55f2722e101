#include "golden/metric_values.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace tumble::golden {
namespace {

using replay::Metrics;

struct Row {
  const char* name;
  const char* unit;
  std::optional<double> (*value)(const Metrics&);
};

constexpr std::array kRows = {
    Row{"lateral_max", "m", [](const Metrics& m) -> std::optional<double> { return m.symmetry.lateral_max; }},
    Row{"lateral_rms", "m", [](const Metrics& m) -> std::optional<double> { return m.symmetry.lateral_rms; }},
    Row{"column_spread", "m", [](const Metrics& m) { return m.symmetry.column_spread; }},
    Row{"gain_max", "J", [](const Metrics& m) -> std::optional<double> { return m.energy.gain_max; }},
    Row{"gain_ratio", "", [](const Metrics& m) { return m.energy.gain_ratio; }},
    Row{"removed", "J", [](const Metrics& m) -> std::optional<double> { return m.energy.removed; }},
    Row{"final", "J", [](const Metrics& m) -> std::optional<double> { return m.energy.final; }},
    Row{"drift_max", "m", [](const Metrics& m) -> std::optional<double> { return m.stacking.drift_max; }},
    Row{"tilt_max", "degrees", [](const Metrics& m) -> std::optional<double> { return m.stacking.tilt_max; }},
    Row{"top_drop_max", "m", [](const Metrics& m) -> std::optional<double> { return m.stacking.top_drop_max; }},
    Row{"lost", "bodies",
        [](const Metrics& m) -> std::optional<double> { return static_cast<double>(m.stacking.lost); }},
    Row{"overlap_max", "m", [](const Metrics& m) -> std::optional<double> { return m.stacking.overlap_max; }},
    Row{"ground_penetration_max", "m",
        [](const Metrics& m) -> std::optional<double> { return m.stacking.ground_penetration_max; }},
    Row{"kinetic_end", "J", [](const Metrics& m) -> std::optional<double> { return m.stacking.kinetic_end; }},
    Row{"frozen_fraction", "", [](const Metrics& m) -> std::optional<double> { return m.stacking.frozen_fraction; }},
    Row{"rest_time", "s", [](const Metrics& m) { return m.stacking.rest_time; }},
};

const Row& row_of(const std::string& name) { return *std::ranges::find(kRows, name, &Row::name); }

}  // namespace

std::vector<const char*> metric_names() {
  std::vector<const char*> names;
  for (const Row& row : kRows) names.push_back(row.name);
  return names;
}

std::string metric_unit(const std::string& name) { return row_of(name).unit; }

Status check_selection(const MetricRule& rule) {
  if (rule.bodies == "all" && rule.axis == "x" && rule.from_step == 0) return {};
  return bad_input("found a choice of bodies, axis or step, wanted none");
}

struct MetricSet::Selected {
  std::optional<replay::Measurer> measurer;
};

MetricSet::MetricSet(const replay::LogHeader& header, const CaseRules& rules) : header_(header), rules_(rules) {
  measurers_.push_back(std::make_unique<Selected>());
  of_rule_.assign(rules.metrics.size(), 0);
}

MetricSet::~MetricSet() = default;

void MetricSet::add(const replay::StepRecord& record) {
  for (const auto& selected : measurers_) {
    if (record.step == 0) {
      selected->measurer.emplace(header_, record);
    } else {
      selected->measurer->add(record);
    }
  }
}

Result<std::vector<std::optional<double>>> MetricSet::finish(const replay::BodyStates& last) {
  std::vector<Metrics> metrics;
  for (const auto& selected : measurers_) metrics.push_back(selected->measurer->finish(last));
  std::vector<std::optional<double>> values;
  for (std::size_t k = 0; k < rules_.metrics.size(); ++k) {
    values.push_back(row_of(rules_.metrics[k].name).value(metrics[of_rule_[k]]));
  }
  return values;
}

}  // namespace tumble::golden
