#include "replay/stream/last_states.h"

#include <algorithm>
#include <cstddef>
#include <variant>
#include <vector>

namespace tumble::replay {

Result<StreamStep> decoded(const StreamReader& stream, const StreamFrame& frame) {
  const Result<std::vector<std::byte>> payload = stream.read(frame);
  if (!payload.ok()) return payload.error();
  return decode_stream_step(frame.kind, *payload, stream.name() + ": byte " + std::to_string(frame.offset));
}

bool wakes(const StreamStep& step, std::uint64_t id) {
  return std::ranges::any_of(step.inputs, [id](const StreamInput& input) {
    const auto* push = std::get_if<StreamPush>(&input);
    const auto* set = std::get_if<StreamSetVelocity>(&input);
    return (push != nullptr && push->id == id) || (set != nullptr && set->id == id);
  });
}

/// Takes from a step, read backwards, the states of the bodies that are still looked for.
void LastStates::see(const StreamStep& step, std::uint64_t before, std::set<std::uint64_t>& ids,
                     std::map<std::uint64_t, std::uint64_t>& woken) {
  const auto found = [&](const StreamState& state) {
    if (ids.erase(state.id) > 0) known_[state.id] = {state, step.step, woken[state.id], before};
  };
  for (const StreamState& state : step.states) {
    if (!state.same) found(state);
  }
  for (const StreamInput& input : step.inputs) {
    const auto* push = std::get_if<StreamPush>(&input);
    const auto* set = std::get_if<StreamSetVelocity>(&input);
    if (push != nullptr) woken[push->id] = step.step;
    if (set != nullptr) woken[set->id] = step.step;
  }
  for (const StreamInput& input : step.inputs) {
    const auto* body = std::get_if<StreamBody>(&input);
    if (body != nullptr) found({body->id, false, body->asleep, body->numbers});
  }
}

Status LastStates::find(const StreamFrame& frame, const std::set<std::uint64_t>& ids, StreamStates& states) {
  std::set<std::uint64_t> wanted = ids;
  std::map<std::uint64_t, std::uint64_t> woken;
  const auto is_older = [&](std::uint64_t id, std::uint64_t step) {  // what is known holds up to that step
    const auto known = known_.find(id);
    return known != known_.end() && known->second.told < frame.step && known->second.before > step;
  };
  const std::vector<StreamFrame>& steps = stream_.steps();
  auto at = std::ranges::lower_bound(steps, frame.step, {}, &StreamFrame::step);
  while (!wanted.empty()) {
    const std::uint64_t step = at == steps.begin() ? 0 : std::prev(at)->step;
    std::erase_if(wanted, [&](std::uint64_t id) {
      if (!is_older(id, step)) return false;
      Known& known = known_.at(id);
      if (known.woken == 0) known.woken = woken[id];
      known.before = std::max(known.before, frame.step);
      return true;
    });
    if (wanted.empty() || at == steps.begin() || std::prev(at)->offset > frame.offset) break;
    const Result<StreamStep> read = decoded(stream_, *--at);
    if (!read.ok()) return read.error();
    see(*read, frame.step, wanted, woken);
  }
  for (const std::uint64_t id : ids) {
    if (wanted.contains(id)) continue;
    const Known& known = known_.at(id);
    StreamState& state = states[id] = known.state;
    state.asleep = state.asleep && (known.woken == 0 || known.woken >= frame.step);
  }
  return {};
}

}  // namespace tumble::replay
