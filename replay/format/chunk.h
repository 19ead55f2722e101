#pragma once

#include <cstdint>
#include <vector>

#include "replay/format/step_record.h"
#include "src/base/hash.h"
#include "src/world/world_state.h"

namespace tumble::replay {

/// A complete state, hidden parts included, from which a session can be continued.
struct Keyframe {
  sim::WorldState state;
  Hash128 continuation_hash;  ///< sim::continuation_hash of it, by the build that wrote the log
};

/// A run of steps and the state before the first of them, before its inputs.
struct Chunk {
  Keyframe keyframe;
  std::uint64_t first_step = 1;
  std::vector<StepRecord> steps;
};

}  // namespace tumble::replay
