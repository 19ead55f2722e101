#include "replay/view/channel_history.h"

#include <algorithm>

namespace tumble::replay {

std::vector<ChannelMoment> channel_history(StateSource& states, const LogReader& log, std::size_t channel,
                                           const ChannelKey& owner, std::uint64_t from, std::uint64_t values) {
  const ChannelKind kind = log.header().declared.channels.at(channel).type.kind;
  const ChannelKey swapped{owner.b, owner.a};
  std::vector<ChannelMoment> history;
  std::uint64_t used = 0;
  for (std::uint64_t k = std::max(from, log.first_state()); k <= log.last_step() && used < values; ++k) {
    ChannelMoment& moment = history.emplace_back();
    moment.step = k;
    ++used;  // of a step that cannot be read too
    const Result<const StepRecord*> record = states.read(k);
    if (!record.ok()) continue;
    const ChannelValues& all = (*record)->extras.values(channel);
    used += all.size() + (*record)->states.size();
    for (const ChannelKey& key : {owner, swapped}) {
      const auto at = std::ranges::lower_bound(all.keys, key);
      if (at == all.keys.end() || *at != key) continue;
      moment.value = number_of(all.value(static_cast<std::size_t>(at - all.keys.begin()), kind));
      break;
    }
  }
  return history;
}

}  // namespace tumble::replay
