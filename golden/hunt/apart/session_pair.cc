#include "golden/hunt/apart/session_pair.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "replay/measure/metric_bound.h"
#include "replay/measure/metric_list.h"
#include "src/base/check.h"
#include "src/base/text.h"
#include "tumble/replay/body_states.h"

namespace tumble::hunt {
namespace {

constexpr double kBeyondAnyBound = std::numeric_limits<double>::infinity();

// The metrics of the session up to each step. The overlap is measured in every step: a blow between two builds that
// meet a step apart is seen in both.
std::vector<replay::Metrics> metrics_by_step(const sim::SceneDef& scene,
                                             const std::vector<replay::StepRecord>& records) {
  const replay::LogHeader header = replay::header_for(scene);
  replay::MeasureOptions options;
  options.overlap_every = 1;
  replay::Measurer measurer(header, options);
  std::vector<replay::Metrics> out;
  for (const replay::StepRecord& record : records) {
    measurer.add(record);
    Result<replay::Metrics> metrics = measurer.finish(record.states);
    SIM_CHECK(metrics.ok());  // all bodies are chosen, from state 0 on
    if (record.step > 0) out.push_back(*std::move(metrics));
  }
  return out;
}

// A value of a measure in both sessions.
struct Both {
  std::optional<double> mine, other;

  [[nodiscard]] double apart() const {
    if (replay::same_value(mine, other)) return 0;
    if (!mine || !other) return kBeyondAnyBound;
    const double by = std::fabs(*mine - *other);
    return std::isfinite(by) ? by : kBeyondAnyBound;
  }
  [[nodiscard]] double allowed(const ApartBound& bound) const {
    const auto size = [](const std::optional<double>& value) { return value && std::isfinite(*value) ? *value : 0; };
    return bound.allowed(size(mine), size(other));
  }
  [[nodiscard]] bool beyond(const ApartBound& bound) const { return apart() > allowed(bound); }
  [[nodiscard]] double times(const ApartBound& bound) const { return apart() / std::max(allowed(bound), 1e-300); }
};

constexpr int kDigitsUsual = 4, kDigitsAll = 17;

std::string value_text(const std::optional<double>& value, const ApartBound& bound, int digits) {
  if (!value) return std::string("none (") + replay::find_metric(bound.measure)->nothing + ")";
  const std::string unit = unit_of(bound);
  return significant(*value, digits) + (unit.empty() ? "" : " " + unit);
}

std::string both_text(const Both& values, const ApartBound& bound) {
  // As many digits as tell them apart.
  int digits = kDigitsUsual;
  while (digits < kDigitsAll && values.mine && values.other && *values.mine != *values.other &&
         significant(*values.mine, digits) == significant(*values.other, digits))
    ++digits;
  return value_text(values.mine, bound, digits) + " here and " + value_text(values.other, bound, digits) + " there";
}

// describe() says a distance beside a bound; without a bound it is said here.
std::string beside_no_bound(double apart, double allowed, const std::string& unit) {
  return allowed > 0 ? "" : ": apart by " + rounded(apart, unit) + ", allowed 0";
}

}  // namespace

std::vector<replay::StepRecord> records_of(const Trace& trace) {
  std::vector<replay::StepRecord> records(trace.states.size());
  for (std::size_t k = 0; k < records.size(); ++k) {
    replay::StepRecord& record = records[k];
    record.step = k;
    record.has_states = true;
    copy_visible(trace.states[k].bodies, record.states);
    if (k == 0) continue;
    record.dt = trace.steps[k - 1].dt;
    record.inputs = trace.steps[k - 1].inputs;
    record.counters = trace.steps[k - 1].counters;
  }
  return records;
}

// The counters of a step know no blow of a fast pair, which the trace does.
SessionPair::SessionPair(const Trace& mine, const std::vector<replay::StepRecord>& other) {
  SIM_CHECK(mine.states.size() == other.size(), mine.states.size(), other.size());
  const std::vector<replay::StepRecord> records = records_of(mine);
  bool met = false;
  for (std::size_t k = 0; k < records.size(); ++k) {
    places_.push_back(replay::farthest_apart(records[k].states, other[k].states));
    met = met || other[k].counters.contacts > 0 || (k > 0 && !mine.steps[k - 1].met.empty());
    if (k > 0 && !met) free_steps_ = k;
  }
  mine_ = metrics_by_step(mine.scene, records);
  other_ = metrics_by_step(mine.scene, other);
}

Judgement SessionPair::judge(const ApartBound& bound) const {
  return bound.measure == kPlace ? judge_place(bound) : judge_metric(bound);
}

Judgement SessionPair::judge_place(const ApartBound& bound) const {
  const auto end = places_.begin() + static_cast<std::ptrdiff_t>(free_steps_) + 1;
  const double allowed = bound.allowed(0, 0);
  const auto first =
      std::find_if(places_.begin(), end, [allowed](const replay::Farthest& one) { return one.distance > allowed; });
  const auto worst = std::max_element(places_.begin(), end, [](const replay::Farthest& a, const replay::Farthest& b) {
    return a.distance < b.distance;
  });
  if (first == end) {
    if (free_steps_ == 0) return not_applicable("something meets in the first step");
    Judgement out = broken(0, 0, "place", worst->distance, allowed, "m");
    out.outcome = Outcome::kHeld;
    return out;
  }
  const auto step = static_cast<std::uint64_t>(first - places_.begin());
  if (!std::isfinite(first->distance))
    return broken(step, first->body, "before anything met, one session alone has the body, or its place is no number");
  std::string what = "before anything met, its place is " + rounded(first->distance, "m") +
                     " from that there; farthest after step " + std::to_string(worst - places_.begin()) + ", body " +
                     std::to_string(worst->body);
  if (!std::isfinite(worst->distance)) return broken(step, first->body, what + ", which has no place in one session");
  what += beside_no_bound(worst->distance, allowed, "m");
  return broken(step, first->body, std::move(what), worst->distance, allowed, "m");
}

Judgement SessionPair::judge_metric(const ApartBound& bound) const {
  if (mine_.empty()) return not_applicable("there is no step");
  if (mine_.back().measured_bodies == 0) return not_applicable("every body is static, or there is none");
  const replay::MetricRow& row = *replay::find_metric(bound.measure);
  const auto both = [&](std::size_t k) { return Both{row.value(mine_[k]), row.value(other_[k])}; };
  const std::size_t last = mine_.size() - 1;
  const Both end = both(last);
  if (!end.mine && !end.other) return not_applicable(std::string("no value in either session: ") + row.nothing);
  if (!end.beyond(bound)) {
    Judgement out = broken(last + 1, 0, bound.measure, end.apart(), end.allowed(bound), row.unit);
    out.outcome = Outcome::kHeld;
    return out;
  }
  // On the way one session may have a value and the other not yet: that counts where it is so in the end.
  const bool has_both = std::isfinite(end.apart());
  std::size_t first = last, worst = last;
  for (std::size_t k = last + 1; k-- > 0;) {
    if (has_both && !std::isfinite(both(k).apart())) continue;
    if (both(k).beyond(bound)) first = k;
    if (both(k).times(bound) > both(worst).times(bound)) worst = k;
  }
  std::string what = bound.measure + " is " + both_text(both(first), bound);
  if (worst != first)
    what += ", farthest apart after step " + std::to_string(worst + 1) + ": " + both_text(both(worst), bound);
  const sim::BodyId body = places_[first + 1].body;
  if (!has_both) return broken(first + 1, body, std::move(what));
  what += beside_no_bound(both(worst).apart(), both(worst).allowed(bound), row.unit);
  return broken(first + 1, body, std::move(what), both(worst).apart(), both(worst).allowed(bound), row.unit);
}

}  // namespace tumble::hunt
