// Statistics of the channels of another engine.
#include "replay/measure/channel_metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace tumble::replay {
namespace {

// A difference of doubles is 0 or 2 for each of these.
TEST(ChannelMetrics, ChangesOfLargeWholeNumbersAreExact) {
  const std::int64_t least = std::numeric_limits<std::int64_t>::min();
  const std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t large = 1ULL << 60U;
  EXPECT_EQ(distance_between(large, large + 1), 1);
  EXPECT_EQ(distance_between(most, most - 3), 3);
  EXPECT_EQ(distance_between(least, least + 1), 1);
  EXPECT_EQ(distance_between(std::int64_t{-1}, std::uint64_t{1}), 2);
  EXPECT_EQ(distance_between(least, std::int64_t{-1} - least), 0x1p64);
  EXPECT_EQ(distance_between(least, most), 0x1.8p64);
  EXPECT_EQ(distance_between(std::int64_t{3}, 0.5), 2.5);
  EXPECT_TRUE(std::isnan(distance_between(std::int64_t{3}, std::string("3"))));

  ChannelMeter meter({{"small", {ChannelKind::kInt64, ChannelScope::kWorld}, ""},
                      {"seed", {ChannelKind::kUint64, ChannelScope::kWorld}, ""}});
  for (const std::uint64_t more : {0U, 1U, 4U}) {
    Extras extras;
    extras.channels.resize(2);
    extras.channels[0].add({}, static_cast<std::int64_t>(more));
    extras.channels[1].add({}, large + more);
    meter.add(extras);
  }
  EXPECT_EQ(meter.metrics()[1].change_max, 3);
  EXPECT_EQ(meter.metrics()[0].change_max, 3);
  EXPECT_EQ(approximations(meter.metrics()),
            (std::vector<std::string>{
                "min, max, mean and last of channel \"seed\" are of the nearest doubles: whole numbers beyond 2^53"}));
}

}  // namespace
}  // namespace tumble::replay
