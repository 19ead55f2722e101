#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "replay/session/state_source.h"
#include "tumble/replay/log_reader.h"
#include "tumble/sim/ids.h"
#include "tumble/sim/vec.h"

namespace tumble::replay {

/// One body in one state.
struct BodyMoment {
  std::uint64_t step = 0;
  bool shown =
      false;  ///< false: the state cannot be read, has no such body, or a value of the body is no finite number
  bool frozen = false;
  sim::Vec3 position = sim::Vec3::Zero();  ///< m
  double speed = 0, spin = 0;              ///< m/s, rad/s
};

/// The body in each state from step `from` on, up to the log's last step and as many as `body_states` allow: a state of
/// n bodies costs n.
std::vector<BodyMoment> body_history(StateSource& states, const LogReader& log, sim::BodyId id, std::uint64_t from,
                                     std::uint64_t body_states);

}  // namespace tumble::replay
