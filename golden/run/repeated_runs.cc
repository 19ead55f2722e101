#include "golden/run/repeated_runs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "golden/judge/judge_metrics.h"
#include "replay/session/state_source.h"
#include "src/base/text.h"
#include "tumble/golden/change.h"
#include "tumble/replay/compare.h"

namespace tumble::golden {
namespace {

using Values = std::vector<std::optional<double>>;

/// The values of one metric that are there, ascending; what is no number stands behind all others.
std::vector<double> sorted(const std::vector<Values>& runs, std::size_t metric) {
  std::vector<double> all;
  for (const Values& values : runs) {
    if (metric < values.size() && values[metric]) all.push_back(*values[metric]);
  }
  std::ranges::sort(all, [](double a, double b) { return a < b || (std::isnan(b) && !std::isnan(a)); });
  return all;
}

/// The fault of the run that is worst for a metric; empty where all runs hold its bounds.
std::string fault_of_worst(const MetricResult& metric, const std::vector<double>& values, std::size_t runs) {
  if (values.size() < runs && !metric.rule.may_be_null) {
    return "null in " + std::to_string(runs - values.size()) + " of " + std::to_string(runs) + " runs";
  }
  if (values.empty()) return "";
  for (const double value : {values.front(), values.back()}) {
    const std::string fault = fault_of_value(metric.rule, value, metric.unit);
    if (!fault.empty()) return "in one of " + std::to_string(runs) + " runs: " + fault;
  }
  return "";
}

/// The distance of the run that is nearest to a bound of the metric, all being within; none: it has no bound.
std::optional<double> room_of(const MetricRule& rule, const std::vector<double>& values) {
  std::optional<double> room;
  if (rule.max) room = *rule.max - values.back();
  if (rule.min) room = std::min(room.value_or(values.front() - *rule.min), values.front() - *rule.min);
  return room;
}

}  // namespace

// A golden that has to be met in every bit is worth nothing where the engine itself does not meet it again.
std::uint64_t runs_wanted(const CaseRules& rules, bool to_bless) {
  const std::uint64_t said = rules.engine ? rules.engine->repeat : 1;
  const bool needs_bits = std::ranges::find(rules.require, VerdictKind::kExact) != rules.require.end();
  return to_bless && rules.is_external() && needs_bits ? std::max<std::uint64_t>(said, 2) : said;
}

RepeatedRuns::RepeatedRuns(replay::LogReader& first, const Reference& reference, Judged& judged)
    : first_(first), reference_(reference), judged_(judged) {
  values_.push_back(judged.values);
}

Status RepeatedRuns::add(replay::LogReader& again) {
  ++runs_;
  Judged judged = judge(again, reference_);
  for (std::string& problem : judged.result.problems) {
    std::vector<std::string>& known = judged_.result.problems;
    if (std::ranges::find(known, problem) == known.end())
      known.push_back("run " + std::to_string(runs_) + ": " + problem);
  }
  values_.push_back(std::move(judged.values));
  return compare(again);
}

Status RepeatedRuns::compare(replay::LogReader& again) {
  const Result<replay::DiffReport> report = replay::diff_logs(first_, again);
  if (!report.ok()) return report.error();
  if (scope_.empty()) {
    for (const std::string& part : report->scope.compared) scope_ += (scope_.empty() ? "" : ", ") + part;
  }
  if (report->identical()) return {};
  if (difference_.empty()) {
    difference_ =
        "run " + std::to_string(runs_) + " differs from run 1: " +
        (report->first ? replay::describe(*report->first) : report->unequal("run 1", "run " + std::to_string(runs_)));
  }
  if (!report->first) return {};
  replay::StateSource a(first_), b(again);
  const auto last = std::min(first_.last_step(), again.last_step());
  const Result<replay::Separation> separation = replay::measure_separation(
      {"run 1", [&](std::uint64_t k) { return a.read(k); }},
      {"another run", [&](std::uint64_t k) { return b.read(k); }}, report->first->step, last);
  if (!separation.ok()) return separation.error();
  if (!apart_ || separation->largest.separation > apart_->separation) apart_ = separation->largest;
  return {};
}

void RepeatedRuns::judge_metrics_of_all() {
  Values medians;
  for (std::size_t k = 0; k < reference_.rules.metrics.size(); ++k) {
    const std::vector<double> values = sorted(values_, k);
    medians.push_back(values.empty() ? std::nullopt : std::optional<double>(values[values.size() / 2]));
  }
  CaseResult& result = judged_.result;
  result.metrics.clear();
  Verdict verdict = judge_metrics(reference_.rules, medians, false, result.metrics);
  for (std::size_t k = 0; k < result.metrics.size(); ++k) {
    MetricResult& metric = result.metrics[k];
    const std::vector<double> values = sorted(values_, k);
    if (!values.empty()) metric.spread = values.back() - values.front();
    const std::string fault = metric.pass ? fault_of_worst(metric, values, values_.size()) : "";
    if (!fault.empty()) {
      metric.pass = false;
      metric.message = fault;
    } else if (metric.pass && metric.spread == 0.0) {
      metric.message = std::string(has_moved(metric) ? "moved" : "unmoved") + ": all " + std::to_string(runs_) +
                       " runs gave this value, so that any change counts";
    } else if (metric.pass && metric.spread) {
      metric.message = (has_moved(metric) ? "moved by more than" : "within") +
                       (" the engine's own spread of " + rounded(*metric.spread, metric.unit));
    }
    if (!metric.pass && metric.spread.value_or(0) > 0) {
      metric.message += "; " + std::to_string(values.size()) + " runs gave " + rounded(values.front(), metric.unit) +
                        " to " + rounded(values.back(), metric.unit);
    }
  }
  const auto failed = std::ranges::count_if(result.metrics, [](const MetricResult& m) { return !m.pass; });
  const auto moved = std::ranges::count_if(result.metrics, has_moved);
  if (failed > 0) {
    verdict = {Outcome::kFail,
               std::to_string(failed) + " of " + count_text(result.metrics.size(), "metric") + " failed"};
  } else if (verdict.outcome == Outcome::kPass) {
    verdict.message = count_text(result.metrics.size(), "metric") + " within bounds in all " + std::to_string(runs_) +
                      " runs, " + std::to_string(moved) + " moved by more than the engine's own spread";
  }
  result.verdict(VerdictKind::kBehaviour) = verdict;
  judged_.values = std::move(medians);
}

void RepeatedRuns::name_near_bounds() {
  CaseResult& result = judged_.result;
  std::string names;
  for (std::size_t k = 0; k < result.metrics.size(); ++k) {
    const MetricResult& metric = result.metrics[k];
    if (!metric.pass || metric.spread.value_or(0) == 0) continue;
    const std::optional<double> room = room_of(metric.rule, sorted(values_, k));
    if (!room || *room >= *metric.spread) continue;
    names += (names.empty() ? "" : ", ") + metric.rule.name;
    result.notes.push_back(std::string(kNearBound) + metric.rule.name + ": a run is " + rounded(*room, metric.unit) +
                           " from it, and the runs are up to " + rounded(*metric.spread, metric.unit) +
                           " from one another: a further run may fail without any change (docs/noisy_engines.md)");
  }
  if (!names.empty()) near_ = ", and are nearer to the bound of " + names + " than to one another";
}

void RepeatedRuns::finish() {
  CaseResult& result = judged_.result;
  result.runs = runs_;
  const std::string runs = std::to_string(runs_) + " runs of the engine";
  if (difference_.empty()) {
    result.runs_message = runs + " agree in every bit compared (" + scope_ +
                          "); the engine's own spread is 0, so metrics are judged against the blessed values alone";
    return;
  }
  // A session that could not be measured has its problem already.
  if (!judged_.values.empty()) {
    judge_metrics_of_all();
    name_near_bounds();
  }
  result.runs_message = runs + " differ among themselves";
  if (apart_ && !apart_->body) result.runs_message += ", in no body's place";
  if (apart_ && apart_->body) {
    result.runs_message += " by up to " + rounded(apart_->separation, "m") + " (body " + std::to_string(*apart_->body) +
                           ", step " + std::to_string(apart_->step) + ")";
  }
  result.runs_message += near_;
  result.runs_message +=
      "; each metric is judged against its own spread over the runs: it has moved where the median "
      "is further from the blessed value";
  result.verdict(VerdictKind::kExact) = {Outcome::kFail, std::string(kDoesNotRepeat) + ": " + difference_};
  result.notes.push_back(difference_);
}

}  // namespace tumble::golden
