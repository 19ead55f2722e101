#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "golden/judge/case_json.h"
#include "replay/measure/channel_metrics.h"
#include "tumble/golden/expected.h"
#include "tumble/replay/channel.h"

/// The channels of another engine in the numbers that a report draws: the first six of numbers.
namespace tumble::golden {

/// Adds the least and the largest value of each in one state to the columns "channel 2 least" and "channel 2 largest",
/// by its place in the log.
void add_channel_values(const std::vector<replay::Channel>& channels, const std::vector<replay::ChannelRow>& row,
                        Json& columns);

/// Adds "channels" [{"key", "name", "unit", "one" (a value of the step as a whole)}], and below "expected" a table
/// "channel 2" of the same columns for each whose values the golden keeps. expected: may be null.
void add_channels(const std::vector<replay::Channel>& channels, const Expected* expected, Json& series);

}  // namespace tumble::golden
