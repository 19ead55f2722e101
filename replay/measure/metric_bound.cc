#include "replay/measure/metric_bound.h"

#include <charconv>
#include <cmath>

namespace tumble::replay {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
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
  if (number.empty() || error != std::errc() || rest != end || bound.bound != bound.bound) return not_understood(text);
  bound.metric = find_metric(name);
  if (bound.metric == nullptr) {
    return bad_input("found no metric \"" + name + "\"; 'tumble measure --json' and docs/metrics.md have the names");
  }
  return bound;
}

}  // namespace tumble::replay
