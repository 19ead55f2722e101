#include "replay/measure/channel_metrics.h"

#include <algorithm>
#include <array>

#include "replay/format/not_finite.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr std::array<const char*, 6> kStatisticNames = {"min", "max", "mean", "last", "change_max", "changes"};

}  // namespace

std::span<const char* const> channel_statistic_names() { return kStatisticNames; }

const char* name_of(ChannelStatistic statistic) { return kStatisticNames.at(static_cast<std::size_t>(statistic)); }

std::optional<ChannelMetricName> parse_channel_metric(std::string_view name) {
  constexpr std::string_view kPrefix = "channel.";
  const std::size_t dot = name.rfind('.');
  if (!name.starts_with(kPrefix) || dot == std::string_view::npos || dot <= kPrefix.size()) return std::nullopt;
  const auto found =
      std::ranges::find(kStatisticNames, name.substr(dot + 1), [](const char* word) { return std::string_view(word); });
  if (found == kStatisticNames.end()) return std::nullopt;
  return ChannelMetricName{std::string(name.substr(kPrefix.size(), dot - kPrefix.size())),
                           static_cast<ChannelStatistic>(found - kStatisticNames.begin())};
}

std::optional<double> ChannelMetrics::value(ChannelStatistic statistic) const {
  if (values == 0) return std::nullopt;
  if (statistic == ChannelStatistic::kChanges) return static_cast<double>(changes);
  if (!is_number(channel.type.kind)) return std::nullopt;
  switch (statistic) {
    case ChannelStatistic::kMin:
      return min;
    case ChannelStatistic::kMax:
      return max;
    case ChannelStatistic::kMean:
      return sum / static_cast<double>(values);
    case ChannelStatistic::kLast:
      return last;
    case ChannelStatistic::kChangeMax:
    case ChannelStatistic::kChanges:
      break;
  }
  return change_max;
}

std::vector<std::string> approximations(const std::vector<ChannelMetrics>& channels) {
  std::vector<std::string> names;
  for (const ChannelMetrics& metrics : channels) {
    if (metrics.rounded) names.push_back(in_quotes(metrics.channel.name));
  }
  if (names.empty()) return {};
  constexpr std::size_t kShown = 3;
  const std::size_t more = names.size() - std::min(names.size(), kShown);
  names.resize(names.size() - more);
  return {"min, max, mean and last of " + std::string(names.size() + more == 1 ? "channel " : "channels ") +
          joined(names, ", ") + (more > 0 ? " and " + std::to_string(more) + " more" : "") +
          " are of the nearest doubles: whole numbers beyond 2^53"};
}

ChannelMeter::ChannelMeter(const std::vector<Channel>& channels) {
  for (const Channel& channel : channels) {
    metrics_.emplace_back();
    metrics_.back().channel = channel;
  }
  row_.resize(channels.size());
}

// std::max drops a NaN; largest() and least() keep it.
void ChannelMeter::compare(ChannelMetrics& metrics, const ChannelValues& now, const ChannelValues& before) const {
  const ChannelKind kind = metrics.channel.type.kind;
  std::size_t j = 0;
  for (std::size_t i = 0; i < now.size(); ++i) {
    while (j < before.size() && before.keys[j] < now.keys[i]) ++j;
    if (j == before.size() || before.keys[j] != now.keys[i]) continue;
    const bool same = is_number(kind) ? now.bits[i] == before.bits[j] : now.bytes[i] == before.bytes[j];
    if (same) continue;
    ++metrics.changes;
    if (!is_number(kind)) continue;
    metrics.change_max = largest(metrics.change_max, distance_between(now.value(i, kind), before.value(j, kind)));
  }
}

void ChannelMeter::add(const Extras& extras) {
  for (std::size_t c = 0; c < metrics_.size(); ++c) {
    ChannelMetrics& metrics = metrics_[c];
    const ChannelValues& now = extras.values(c);
    if (!first_) compare(metrics, now, before_.values(c));
    const ChannelKind kind = metrics.channel.type.kind;
    ChannelRow& row = row_[c];
    row = {now.size(), metrics.changes};
    for (std::size_t i = 0; i < now.size(); ++i) {
      const bool first_value = metrics.values++ == 0;
      if (!is_number(kind)) continue;
      metrics.rounded = metrics.rounded || is_rounded(now.value(i, kind));
      const double value = number_of(now.value(i, kind));
      metrics.min = first_value ? value : least(metrics.min, value);
      metrics.max = first_value ? value : largest(metrics.max, value);
      metrics.sum += value;
      metrics.last = i == 0 ? value : largest(metrics.last, value);
      row.min = i == 0 ? value : least(row.min, value);
      row.max = i == 0 ? value : largest(row.max, value);
      row.sum += value;
    }
  }
  if (metrics_.empty()) return;
  before_.channels = extras.channels;
  first_ = false;
}

}  // namespace tumble::replay
