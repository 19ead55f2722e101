#include "replay/measure/metric_bound.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "src/base/text.h"

namespace tumble::replay {
namespace {

/// No value of a session is as large, whatever its unit: limits.h bounds masses, sizes and speeds.
constexpr double kBeyondAll = 1e40;

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

bool is_always_true(const MetricBound& bound) {
  const bool is_upper =
      bound.comparison == MetricBound::Comparison::kAtMost || bound.comparison == MetricBound::Comparison::kBelow;
  const bool is_strict =
      bound.comparison == MetricBound::Comparison::kAbove || bound.comparison == MetricBound::Comparison::kBelow;
  // "> -1" is as empty as ">= 0"; "> 0" is not.
  const double inclusive = is_strict ? std::nextafter(bound.bound, is_upper ? -INFINITY : INFINITY) : bound.bound;
  const std::optional<double> value(inclusive);
  return judges_nothing(bound.metric->name, is_upper ? std::nullopt : value, is_upper ? value : std::nullopt);
}

Error not_understood(const std::string& text) {
  return bad_input("found \"" + text + "\", wanted NAME<=NUMBER (or <, >=, >), as in lateral_max<=0");
}

}  // namespace

bool MetricBound::holds(const std::optional<double>& value) const {
  if (!value || !std::isfinite(*value)) return false;
  switch (comparison) {
    case Comparison::kBelow:
      return *value < bound;
    case Comparison::kAtMost:
      return *value <= bound;
    case Comparison::kAbove:
      return *value > bound;
    case Comparison::kAtLeast:
      return *value >= bound;
  }
  return false;
}

std::string MetricBound::found_text(const EngineAxes& axes, const Metrics& metrics) const {
  if (const std::optional<NotFinite>& lost = metric->spoiled_by(metrics)) return "no number: " + to_string(*lost, axes);
  const std::optional<double> value = metric->value_in(axes, metrics);
  if (!value) return std::string("no value: ") + metric->nothing;
  std::string unit = metric->unit_in(axes);
  if (metric->channel != nullptr && metric->statistic != ChannelStatistic::kChanges) {
    const std::string_view name(metric->channel);
    const auto found = std::ranges::find(metrics.channels, name, [](const auto& m) { return m.channel.name; });
    if (found != metrics.channels.end()) unit = found->channel.unit;
  }
  return exact(*value) + (unit.empty() ? "" : " ") + unit;
}

Result<MetricBound> parse_metric_bound(const std::string& text) {
  const std::size_t at = text.find_first_of("<>");
  if (at == std::string::npos) return not_understood(text);
  const bool with_equal = at + 1 < text.size() && text[at + 1] == '=';
  const std::string name = trimmed(text.substr(0, at));
  const std::string number = trimmed(text.substr(at + (with_equal ? 2 : 1)));
  MetricBound bound;
  bound.text = text;
  if (text[at] == '<') {
    bound.comparison = with_equal ? MetricBound::Comparison::kAtMost : MetricBound::Comparison::kBelow;
  } else {
    bound.comparison = with_equal ? MetricBound::Comparison::kAtLeast : MetricBound::Comparison::kAbove;
  }
  const char* end = number.data() + number.size();
  const auto [rest, error] = std::from_chars(number.data(), end, bound.bound);
  if (number.empty() || error != std::errc() || rest != end || !std::isfinite(bound.bound)) return not_understood(text);
  bound.metric = find_metric(name);
  if (bound.metric == nullptr) {
    std::vector<std::string_view> names;
    for (const MetricRow& row : metric_list()) names.emplace_back(row.name);
    const std::string_view near = nearest_word(name, names);
    return bad_input("found no metric \"" + name +
                     (near.empty() ? std::string("\"; ") : "\"; did you mean \"" + std::string(near) + "\"? ") +
                     "'tumble measure --json' and docs/metrics.md have the names, and channel.NAME.max the "
                     "largest value of a channel, parting_time.0.01 the time up to which no body is further than "
                     "0.01 m from its place in another session");
  }
  if (is_always_true(bound)) {
    return bad_input("found \"" + text +
                     "\", which holds for every session and judges nothing; wanted a bound that can fail");
  }
  return bound;
}

bool judges_nothing(std::string_view name, const std::optional<double>& min, const std::optional<double>& max) {
  const MetricRow* const metric = find_metric(name);
  if (metric == nullptr || (!min && !max)) return false;
  return (!min || *min <= std::max(metric->low, -kBeyondAll)) && (!max || *max >= std::min(metric->high, kBeyondAll));
}

Status check_measured(const Metrics& metrics) {
  if (metrics.measured_steps == 0) {
    return bad_input("found no step to judge: the measuring begins with the last state, that of step " +
                     std::to_string(metrics.steps));
  }
  if (metrics.measured_bodies == 0) return bad_input("found no body to judge: every body is static, or there is none");
  return {};
}

}  // namespace tumble::replay
