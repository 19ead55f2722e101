#include "golden/suite/metric_values.h"

#include <algorithm>

#include "replay/measure/metric_bound.h"
#include "replay/measure/metric_list.h"
#include "replay/measure/mirrored_pair.h"
#include "src/base/check.h"

namespace tumble::golden {
namespace {

constexpr std::uint64_t kOrderSeed = 7;      // of the names that order_error compares with
const sim::Vec3 kShift = {1024, -512.5, 0};  // m, what shift_error compares with; exact on the grid of positions

bool same_choice(const MetricRule& a, const MetricRule& b) {
  return a.bodies == b.bodies && a.axis == b.axis && a.has_axis == b.has_axis && a.from_step == b.from_step;
}

/// The transform of the scene that a metric compares with; none for a metric of one session.
std::optional<sim::Transform> transform_for(const MetricRule& rule) {
  sim::Transform transform;
  if (rule.name == "mirror_error") {
    (rule.axis == "y" ? transform.mirror_y : transform.mirror_x) = true;
  } else if (rule.name == "order_error") {
    transform.permute = kOrderSeed;
  } else if (rule.name == "shift_error") {
    transform.shift = kShift;
  }
  return transform.identity() ? std::nullopt : std::optional<sim::Transform>(transform);
}

/// Errors (kBadInput): an axis that is not horizontal in the engine's own axes.
Status check_axis(const MetricRule& rule, const replay::EngineAxes& axes) {
  if (!rule.has_axis) return {};
  const std::string first(1, axes.along(0).letter), second(1, axes.along(1).letter);
  if (rule.axis == first || rule.axis == second) return {};
  return bad_input("metrics.toml:" + std::to_string(rule.line) + ": " + rule.name + ": axis: found " + rule.axis +
                   ", which points up in the " + "engine's axes (" + to_string(axes) + "); wanted " +
                   std::min(first, second) + " or " + std::max(first, second));
}

}  // namespace

std::vector<const char*> metric_names() {
  std::vector<const char*> names;
  for (const replay::MetricRow& row : replay::metric_list()) names.push_back(row.name);
  return names;
}

std::string metric_unit(const std::string& name) {
  const replay::MetricRow* row = replay::find_metric(name);
  return row == nullptr ? "" : row->unit;
}

Status check_selection(const MetricRule& rule) {
  const Result<replay::BodyChoice> bodies = replay::parse_bodies(rule.bodies);
  return bodies.ok() ? Status() : Status(bodies.error());
}

Result<replay::MeasureOptions> options_of(const MetricRule& rule, const replay::EngineAxes& axes,
                                          const replay::BodyTable& named) {
  if (Status ok = check_axis(rule, axes); !ok.ok()) return ok.error();
  Result<replay::BodyChoice> bodies = replay::parse_bodies(rule.bodies, named);
  if (!bodies.ok()) {
    return bad_input("metrics.toml:" + std::to_string(rule.line) + ": " + rule.name + ": " + bodies.error().message);
  }
  replay::MeasureOptions options;
  options.bodies = *std::move(bodies);
  const bool second = rule.has_axis && rule.axis == std::string(1, axes.along(1).letter);
  options.lateral = second ? replay::LateralAxis::kY : replay::LateralAxis::kX;
  options.from_step = rule.from_step;
  return options;
}

bool needs_transformed_scene(const MetricRule& rule) { return transform_for(rule).has_value(); }

MetricSet::MetricSet(const replay::LogHeader& header, const CaseRules& rules) : header_(header), rules_(rules) {
  replay::BodyTable named;
  named.add(header.declared.bodies, {});
  std::vector<const MetricRule*> choices;
  for (const MetricRule& rule : rules.metrics) {
    const auto known =
        std::ranges::find_if(choices, [&](const MetricRule* other) { return same_choice(rule, *other); });
    of_rule_.push_back(static_cast<std::size_t>(known - choices.begin()));
    if (known != choices.end()) continue;
    choices.push_back(&rule);
    const Result<replay::MeasureOptions> options = options_of(rule, header.axes(), named);
    if (choices_.ok() && !options.ok()) choices_ = options.error();
    measurers_.emplace_back(header, options.ok() ? *options : replay::MeasureOptions());
  }
  others_read_ = open_others();
}

Status MetricSet::open_others() {
  std::map<std::string, std::vector<double>> distances;
  for (const MetricRule& rule : rules_.metrics) {
    if (!rule.against.empty()) distances[rule.against_path].push_back(replay::find_metric(rule.name)->beyond);
  }
  for (const auto& [path, beyond] : distances) {
    Result<replay::LogReader> log = replay::LogReader::open(path);
    if (!log.ok()) return log.error();
    if (!log->condition().whole()) return damaged(path + " is " + log->condition().summary(log->last_step()));
    Other& other = others_[path];
    other.log = std::make_unique<replay::LogReader>(*std::move(log));
    other.meter = std::make_unique<replay::PartingMeter>(*other.log, beyond);
  }
  return {};
}

std::optional<double> MetricSet::value_of(const MetricRule& rule, const replay::Metrics& metrics) const {
  const replay::MetricRow& row = *replay::find_metric(rule.name);
  if (!row.needs_other_session()) return row.value(metrics);
  replay::Metrics with_partings;
  with_partings.partings = others_.at(rule.against_path).meter->partings();
  return row.value(with_partings);
}

void MetricSet::add(const replay::StepRecord& record) {
  for (replay::Measurer& measurer : measurers_) measurer.add(record);
  for (auto& [path, other] : others_) {
    if (others_read_.ok()) others_read_ = other.meter->add(record);
  }
}

Result<std::optional<double>> MetricSet::pair_value(const MetricRule& rule) const {
  // Transformed scenes in this engine say nothing about another one.
  if (rules_.is_external()) return std::optional<double>();
  const std::optional<sim::Transform> wanted = transform_for(rule);
  SIM_CHECK(wanted.has_value(), std::string_view(rule.name));
  const sim::Transform& transform = *wanted;
  const Result<replay::PairReport> report = replay::run_mirrored_pair(header_.scene, transform);
  if (!report.ok()) return report.error();
  replay::Metrics metrics;
  replay::set_pair_error(transform, *report, metrics.symmetry);
  return replay::find_metric(rule.name)->value(metrics);
}

Result<std::vector<std::optional<double>>> MetricSet::finish(const replay::BodyStates& last) {
  if (!choices_.ok()) return choices_.error();
  if (!others_read_.ok()) return others_read_.error();
  std::vector<replay::Metrics> metrics;
  for (std::size_t k = 0; k < measurers_.size(); ++k) {
    const Result<replay::Metrics> measured = measurers_[k].finish(last);
    if (!measured.ok()) {
      const auto first = static_cast<std::size_t>(std::ranges::find(of_rule_, k) - of_rule_.begin());
      const MetricRule& rule = rules_.metrics[first];
      return Error{measured.error().kind,
                   "metrics.toml:" + std::to_string(rule.line) + ": " + rule.name + ": " + measured.error().message};
    }
    if (Status ok = replay::check_measured(*measured); !ok.ok()) return ok.error();
    metrics.push_back(*measured);
  }
  std::vector<std::optional<double>> values;
  for (std::size_t k = 0; k < rules_.metrics.size(); ++k) {
    const MetricRule& rule = rules_.metrics[k];
    Result<std::optional<double>> value = std::optional<double>();
    value =
        transform_for(rule) ? pair_value(rule) : Result<std::optional<double>>(value_of(rule, metrics[of_rule_[k]]));
    if (!value.ok()) return value.error();
    values.push_back(*value);
  }
  return values;
}

}  // namespace tumble::golden
