#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "replay/session/state_source.h"
#include "tumble/replay/channel.h"
#include "tumble/replay/log_reader.h"

namespace tumble::replay {

/// One value of a channel.
struct ChannelMoment {
  std::uint64_t step = 0;
  double value = std::numeric_limits<double>::quiet_NaN();  ///< NaN: the step cannot be read, or has no such value
};

/// The value that a channel has for one owner in each step from `from` on, up to the log's last step and as many as
/// `values` allow: a step with n values of the channel costs n. channel: by index in LogHeader::declared.channels. The
/// order of the bodies of a pair does not matter.
std::vector<ChannelMoment> channel_history(StateSource& states, const LogReader& log, std::size_t channel,
                                           const ChannelKey& owner, std::uint64_t from, std::uint64_t values);

}  // namespace tumble::replay
