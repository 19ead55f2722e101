#include "replay/view/body_history.h"

#include <algorithm>

#include "replay/format/not_finite.h"

namespace tumble::replay {

std::vector<BodyMoment> body_history(StateSource& states, const LogReader& log, sim::BodyId id, std::uint64_t from,
                                     std::uint64_t body_states) {
  std::vector<BodyMoment> history;
  std::uint64_t used = 0;
  for (std::uint64_t k = std::max(from, log.first_state()); k <= log.last_step() && used < body_states; ++k) {
    BodyMoment& moment = history.emplace_back();
    moment.step = k;
    ++used;  // of a step that cannot be read too
    const Result<const StepRecord*> record = states.read(k);
    if (!record.ok()) continue;
    const BodyStates& all = (*record)->states;
    used += all.size();
    const auto at = std::ranges::lower_bound(all.id, id);
    if (at == all.id.end() || *at != id) continue;
    const auto i = static_cast<std::size_t>(at - all.id.begin());
    if (!is_finite(all, i)) continue;
    moment.shown = true;
    moment.frozen = all.frozen[i] != 0;
    moment.position = all.position[i];
    moment.speed = sim::length(all.velocity[i]);
    moment.spin = sim::length(all.spin[i]);
  }
  return history;
}

}  // namespace tumble::replay
