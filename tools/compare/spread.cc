#include "tools/compare/spread.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "src/base/text.h"

namespace tumble::tools {
namespace {

constexpr double kLeastRoom = 0.01;        // of the median, where runs differ
constexpr double kLibrariesDiffer = 1e-9;  // of the value, where they do not; see replay::same_value()
constexpr int kDigitsMax = 15;
constexpr unsigned char kFirstPrintable = 0x20;

/// A text of TOML between quotes.
std::string toml_quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    const bool prints = static_cast<unsigned char>(c) >= kFirstPrintable && c != '\x7f';
    out += prints ? std::string(1, c) : "\\u00" + hex_digits(std::string_view(&c, 1));
  }
  return out + '"';
}

// Outwards to two digits of the room, so that a person can read the bound: 6.9983 with a room of 0.07 is 6.998.
double outwards(double bound, double room, bool up) {
  if (room <= 0 || bound == 0) return bound;
  const int digits = 1 - static_cast<int>(std::floor(std::log10(room)));
  if (digits > kDigitsMax) return bound;
  const double scale = std::pow(10.0, std::max(digits, 0));
  const double rounded_value = (up ? std::ceil(bound * scale) : std::floor(bound * scale)) / scale;
  // The decimal itself, where the quotient is its neighbour.
  return std::strtod(fixed(rounded_value, std::max(digits, 0)).c_str(), nullptr);
}

/// The values that are there, ascending; what is no number is left out.
std::vector<double> sorted(const std::vector<std::optional<double>>& values) {
  std::vector<double> there;
  for (const std::optional<double>& value : values) {
    if (value && std::isfinite(*value)) there.push_back(*value);
  }
  std::ranges::sort(there);
  return there;
}

std::string in_runs(std::size_t some, std::size_t all) {
  return " in " + std::to_string(some) + " of " + std::to_string(all) + " runs";
}

std::string why_none(const MetricSpread& spread, std::size_t there, bool repeats) {
  const std::size_t runs = spread.values.size();
  const auto null =
      static_cast<std::size_t>(std::ranges::count(spread.values, false, &std::optional<double>::has_value));
  if (null > 0) return "no value" + in_runs(null, runs);
  if (there < runs) return "not finite" + in_runs(runs - there, runs);
  if (!repeats && !spread.metric->counts() && spread.least == 0 && spread.largest == 0) {
    return "0 in all runs, which gives no scale";
  }
  return "";
}

/// The least value that there can be. A bound at it judges nothing, or only that there is a value, which each of the
/// runs had.
double least_of(const replay::MetricRow& metric) {
  constexpr std::array kNeverNegative = {"gain_ratio",  "column_spread",  "mirror_error", "order_error",
                                         "shift_error", "momentum_drift", "rest_time"};
  const bool never_negative = std::ranges::find(kNeverNegative, std::string_view(metric.name)) != kNeverNegative.end();
  return never_negative ? std::max(metric.low, 0.0) : metric.low;
}

void propose(MetricSpread& spread, bool repeats) {
  const replay::MetricRow& metric = *spread.metric;
  const double size = std::max(std::fabs(spread.least), std::fabs(spread.largest));
  const double room =
      repeats ? kLibrariesDiffer * size : std::max(spread.spread(), kLeastRoom * std::fabs(spread.median));
  double min = spread.least - room, max = spread.largest + room;
  if (metric.counts()) {
    min = std::floor(spread.least - (repeats ? 0 : room));
    max = std::ceil(spread.largest + (repeats ? 0 : room));
  } else if (!repeats) {
    min = outwards(min, room, false);
    max = outwards(max, room, true);
  }
  if (min > least_of(metric)) spread.min = min;
  // Sessions that stay together for longer than usual are no fault.
  if (max < metric.high && !metric.needs_other_session()) spread.max = max;
  if (spread.min) spread.room = std::max(spread.room, spread.least - *spread.min);
  if (spread.max) spread.room = std::max(spread.room, *spread.max - spread.largest);
  if (!spread.min && !spread.max) spread.without_bound = "the runs leave no value out that there can be";
}

}  // namespace

MetricSpread spread_of(const replay::MetricRow& metric, std::vector<std::optional<double>> values, bool repeats) {
  MetricSpread spread;
  spread.metric = &metric;
  spread.values = std::move(values);
  const std::vector<double> there = sorted(spread.values);
  if (!there.empty()) {
    const std::size_t half = there.size() / 2;
    spread.least = there.front();
    spread.largest = there.back();
    spread.median = there.size() % 2 == 1 ? there[half] : there[half - 1] + (there[half] - there[half - 1]) / 2;
  }
  spread.without_bound = why_none(spread, there.size(), repeats);
  if (spread.without_bound.empty()) propose(spread, repeats);
  return spread;
}

std::string toml_of(const MetricSpread& spread, const MeasureArguments& over, const std::string& against) {
  const std::string unit = spread.metric->unit;
  std::string text = "[[metric]]\nname = " + toml_quoted(spread.metric->name) + '\n';
  if (over.bodies != "all") text += "bodies = " + toml_quoted(over.bodies) + '\n';
  if (!over.axis.empty()) text += "axis = " + toml_quoted(over.axis) + '\n';
  if (over.from_step.value_or(0) > 0) text += "from_step = " + std::to_string(*over.from_step) + '\n';
  if (!against.empty()) text += "against = " + toml_quoted(against) + '\n';
  if (spread.min) text += "min = " + number_text(*spread.min) + '\n';
  if (spread.max) text += "max = " + number_text(*spread.max) + '\n';
  std::string why = std::to_string(spread.values.size()) + " runs gave " + rounded(spread.least, unit);
  if (spread.spread() > 0) why += " to " + rounded(spread.largest, unit);
  const std::string change = spread.min && spread.max ? "change" : spread.max ? "rise" : "fall";
  if (spread.certain() > 0) {
    why += "; a " + change + " of up to " + rounded(spread.room, unit) + " may pass in every run, one of more than " +
           rounded(spread.certain(), unit) + " fails in every run";
  } else {
    why += "; any " + change + " fails";
  }
  return text + "why = " + toml_quoted(why) + '\n';
}

}  // namespace tumble::tools
