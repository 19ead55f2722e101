#include "golden/judge/channel_series.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "replay/format/not_finite.h"
#include "src/base/text.h"

namespace tumble::golden {
namespace {

constexpr std::size_t kChannelsDrawn = 6;

/// Six digits are more than a plot shows, and a third of the text.
double rounded_number(double value) { return std::strtod(significant(value, 6).c_str(), nullptr); }

/// The name of a table of a channel, and of its columns, by the channel's place: "channel 2", "channel 2 least".
std::string channel_key(std::size_t channel, const std::string& part = "") {
  return "channel " + std::to_string(channel) + (part.empty() ? "" : " " + part);
}

/// The channels that the report draws, by their places in the log: the first ones of numbers.
std::vector<std::size_t> drawn_channels(const std::vector<replay::Channel>& channels) {
  std::vector<std::size_t> drawn;
  for (const std::size_t c : listed_order(channels)) {
    if (drawn.size() < kChannelsDrawn && is_number(channels[c].type.kind)) drawn.push_back(c);
  }
  return drawn;
}

Json channels_json(const std::vector<replay::Channel>& channels) {
  Json list = Json::array();
  for (const std::size_t c : drawn_channels(channels)) {
    list.push_back({{"key", channel_key(c)},
                    {"name", printable(channels[c].name)},
                    {"unit", printable(channels[c].unit)},
                    {"one", channels[c].type.scope == replay::ChannelScope::kWorld}});
  }
  return list;
}

/// The values that a golden keeps of a channel: the largest and the least of each state.
Json expected_channel(const replay::Channel& channel, std::size_t place, const ExpectedExtras& extras) {
  Json table = Json::object();
  const auto kept = std::ranges::find(extras.channels, channel.name, [](const auto& one) { return one.channel.name; });
  if (kept == extras.channels.end() || !is_number(kept->channel.type.kind)) return table;
  for (const KeptValues& state : kept->values) {
    double least = INFINITY, largest = -INFINITY;
    for (std::size_t i = 0; i < state.values.size(); ++i) {
      const double value = replay::number_of(state.values.value(i, kept->channel.type.kind));
      least = replay::least(least, value);
      largest = replay::largest(largest, value);
    }
    if (!std::isfinite(least) || !std::isfinite(largest)) continue;
    table["step"].push_back(state.step);
    table[channel_key(place, "largest")].push_back(rounded_number(largest));
    table[channel_key(place, "least")].push_back(rounded_number(least));
  }
  return table;
}

}  // namespace

void add_channel_values(const std::vector<replay::Channel>& channels, const std::vector<replay::ChannelRow>& row,
                        Json& columns) {
  for (const std::size_t c : drawn_channels(channels)) {
    const auto value = [&](double number) {
      return row[c].values > 0 && std::isfinite(number) ? Json(rounded_number(number)) : Json(nullptr);
    };
    columns[channel_key(c, "largest")].push_back(value(row[c].max));
    columns[channel_key(c, "least")].push_back(value(row[c].min));
  }
}

void add_channels(const std::vector<replay::Channel>& channels, const Expected* expected, Json& series) {
  series["channels"] = channels_json(channels);
  if (expected == nullptr || !expected->extras) return;
  for (const std::size_t c : drawn_channels(channels)) {
    series["expected"][channel_key(c)] = expected_channel(channels[c], c, *expected->extras);
  }
}

}  // namespace tumble::golden
