#include "golden/hunt/apart/apart_bounds.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "replay/measure/metric_list.h"
#include "src/base/text.h"

namespace tumble::hunt {
namespace {

constexpr std::string_view kMeasurePrefix = "against_";
constexpr double kHundred = 100;  // a part is written in percent

// Metrics that compare with a transformed scene are relations of a hunt already; those of channels and of a third
// session have no value here.
bool has_metric(std::string_view name) {
  const replay::MetricRow* row = replay::find_metric(name);
  return row != nullptr && row->channel == nullptr && !row->needs_other_session() && !name.ends_with("_error");
}

std::optional<double> number_in(std::string_view text) {
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool right = error == std::errc() && rest == text.data() + text.size() && std::isfinite(value) && value >= 0;
  return right ? std::optional(value) : std::nullopt;
}

std::optional<double> percent_in(std::string_view text) {
  const auto value = text.ends_with('%') ? number_in(text.substr(0, text.size() - 1)) : std::nullopt;
  return value ? std::optional(*value / kHundred) : std::nullopt;
}

// "0.002+10%"; the plus of an exponent is none of these.
bool read_amounts(std::string_view text, ApartBound& bound) {
  if (const auto part = percent_in(text)) {
    bound.part = *part;
    return true;
  }
  const std::size_t plus = text.ends_with('%') ? text.rfind('+') : std::string_view::npos;
  const auto amount = number_in(text.substr(0, plus));
  const auto part = plus == std::string_view::npos ? std::optional(0.0) : percent_in(text.substr(plus + 1));
  if (!amount || !part) return false;
  bound.amount = *amount;
  bound.part = *part;
  return true;
}

// The percent that were given: of the numbers nearby that read as the part, the one with the fewest digits.
std::string percent_text(double part) {
  constexpr int kDigitsMost = 15;
  const double percent = kHundred * part;
  for (int digits = 1; digits <= kDigitsMost; ++digits) {
    const auto rounded_percent = number_in(significant(percent, digits));
    if (rounded_percent && *rounded_percent / kHundred == part) return number_text(*rounded_percent);
  }
  return number_text(percent);
}

Result<ApartBound> read_bound(const std::string& word) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos) {
    return bad_input("--within: found " + in_quotes(word) +
                     ", wanted bits, bounds, or METRIC=AMOUNT as in gain_max=0.1, gain_max=5% or gain_max=0.1+5%");
  }
  ApartBound bound;
  bound.measure = word.substr(0, equals);
  if (bound.measure != kPlace && !has_metric(bound.measure)) {
    std::vector<std::string_view> known = {kPlace};
    for (const replay::MetricRow& row : replay::metric_list()) {
      if (has_metric(row.name)) known.emplace_back(row.name);
    }
    const std::string_view nearest = nearest_word(bound.measure, known);
    return bad_input("--within: found " + in_quotes(bound.measure) + ", wanted " + list_text(known) +
                     (nearest.empty() ? "" : "; did you mean \"" + std::string(nearest) + "\"?"));
  }
  if (!read_amounts(std::string_view(word).substr(equals + 1), bound)) {
    return bad_input("--within: " + bound.measure + ": found " + in_quotes(word.substr(equals + 1)) +
                     ", wanted an amount of at least 0, a part of the larger value, or both: 0.1, 5%, 0.1+5%");
  }
  return bound;
}

}  // namespace

double ApartBound::allowed(double a, double b) const { return amount + part * std::max(std::fabs(a), std::fabs(b)); }

std::vector<ApartBound> usual_bounds() {
  return {
      {kPlace, 1e-6, 0},
      {"lost", 0, 0},
      {"gain_ratio", 0.02, 0.1},
      {"overlap_peak", 0.02, 0.5},
      {"ground_penetration_peak", 0.02, 0.5},
  };
}

Result<std::vector<ApartBound>> read_bounds(const std::vector<std::string>& words) {
  std::vector<ApartBound> usual, own;
  bool bits = false;
  for (const std::string& word : words) {
    if (word == "bounds") {
      usual = usual_bounds();
      continue;
    }
    bits |= word == "bits";
    if (word == "bits") continue;
    Result<ApartBound> bound = read_bound(word);
    if (!bound.ok()) return bound.error();
    if (std::ranges::find(own, bound->measure, &ApartBound::measure) != own.end())
      return bad_input("--within: found " + bound->measure + " twice, wanted one bound of each measure");
    own.push_back(*std::move(bound));
  }
  if (bits && words.size() > 1)
    return bad_input("--within: found bits and another word, wanted bits alone: equal bits leave nothing to bound");
  for (ApartBound& bound : own) {
    const auto known = std::ranges::find(usual, bound.measure, &ApartBound::measure);
    if (known != usual.end()) {
      *known = bound;
    } else {
      usual.push_back(bound);
    }
  }
  return usual;
}

std::string to_text(const ApartBound& bound) {
  std::string text = bound.measure + "=";
  if (bound.amount > 0 || !(bound.part > 0)) text += number_text(bound.amount);
  if (bound.part > 0) text += (bound.amount > 0 ? "+" : "") + percent_text(bound.part) + "%";
  return text;
}

std::string unit_of(const ApartBound& bound) {
  return bound.measure == kPlace ? "m" : replay::find_metric(bound.measure)->unit;
}

std::string relation_of(const ApartBound& bound) { return std::string(kMeasurePrefix) + bound.measure; }

std::optional<std::string> measure_of(std::string_view relation) {
  if (!relation.starts_with(kMeasurePrefix)) return std::nullopt;
  return std::string(relation.substr(kMeasurePrefix.size()));
}

}  // namespace tumble::hunt
