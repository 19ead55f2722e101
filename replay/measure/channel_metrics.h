#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/replay/channel.h"
#include "tumble/replay/extras.h"

/// Statistics of channels: the metrics channel.NAME.min, .max, .mean, .last, .change_max and .changes.
namespace tumble::replay {

enum class ChannelStatistic : std::uint8_t {
  kMin = 0,        ///< over all values of all measured states
  kMax = 1,        ///< likewise
  kMean = 2,       ///< likewise
  kLast = 3,       ///< the largest of the last state that has a value
  kChangeMax = 4,  ///< the largest change of the value of a body, a pair or the world from one state to the next
  kChanges = 5     ///< the number of such changes
};

/// "min", "max", …, in the order of their values.
std::span<const char* const> channel_statistic_names();
const char* name_of(ChannelStatistic statistic);

/// One channel over a session.
struct ChannelMetrics {
  Channel channel;
  std::uint64_t values = 0;   ///< over all states
  std::uint64_t changes = 0;  ///< to the bit
  /// Of a channel of numbers with a value. A value that is no number makes each of them NaN.
  double min = 0, max = 0, sum = 0, last = 0, change_max = 0;
  bool rounded = false;  ///< a value is a whole number that no double is; change_max is exact up to 2^53 all the same

  /// None: no value, or a channel of bytes or text, which has only changes.
  [[nodiscard]] std::optional<double> value(ChannelStatistic statistic) const;
};

/// One channel in one state.
struct ChannelRow {
  std::uint64_t values = 0;   ///< in this state
  std::uint64_t changes = 0;  ///< to the bit, since the measuring began
  /// Of a channel of numbers with a value. A value that is no number makes each of them NaN.
  double min = 0, max = 0, sum = 0;
  [[nodiscard]] double mean() const { return sum / static_cast<double>(values); }
};

/// For people: which of them are not exact, and why.
std::vector<std::string> approximations(const std::vector<ChannelMetrics>& channels);

/// The parts of "channel.NAME.max"; none where a text is no such name.
struct ChannelMetricName {
  std::string channel;
  ChannelStatistic statistic = ChannelStatistic::kMax;
};
std::optional<ChannelMetricName> parse_channel_metric(std::string_view name);

/// Measures the channels of a session state by state.
class ChannelMeter {
 public:
  explicit ChannelMeter(const std::vector<Channel>& channels);
  void add(const Extras& extras);
  [[nodiscard]] const std::vector<ChannelMetrics>& metrics() const { return metrics_; }
  /// Of the state added last, by channel.
  [[nodiscard]] const std::vector<ChannelRow>& row() const { return row_; }

 private:
  void compare(ChannelMetrics& metrics, const ChannelValues& now, const ChannelValues& before) const;

  std::vector<ChannelMetrics> metrics_;
  std::vector<ChannelRow> row_;
  Extras before_;
  bool first_ = true;
};

}  // namespace tumble::replay
