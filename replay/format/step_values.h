#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "tumble/replay/extras.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// Collects the values of one step in any order, and checks each.
class StepValues {
 public:
  explicit StepValues(std::vector<Channel> channels) : channels_(std::move(channels)), values_(channels_.size()) {}

  /// Errors (kBadInput): no such channel; a value of another kind than the channel's; bodies that do not fit its scope;
  /// a second value of one channel and key; a text beyond kValueBytesMax.
  Status set(std::size_t channel, const ChannelValue& value, const ChannelKey& key);

  /// Moves the values into `extras` in the order of a log, and begins the next step.
  void move_to(Extras& extras);

  [[nodiscard]] bool empty() const;
  [[nodiscard]] const std::vector<Channel>& channels() const { return channels_; }

 private:
  std::vector<Channel> channels_;
  std::vector<std::map<ChannelKey, ChannelValue>> values_;  // by channel
};

}  // namespace tumble::replay
