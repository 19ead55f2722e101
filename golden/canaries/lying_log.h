#pragma once

#include <cstdint>
#include <functional>

#include "replay/log/byte_memory.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"
#include "tumble/sim/step.h"
#include "tumble/sim/world_state.h"

namespace tumble::golden {

using Lie = std::function<void(sim::WorldState& state, sim::StepCounters& counters)>;

/// Records a session whose log lies in one step, if it lies: what is written is altered, not what happens. chunk: steps
/// of a chunk. Errors: a world that cannot be made or stepped, a log that cannot be written.
Result<replay::MemoryFile> record_lying(const sim::SceneDef& scene, std::uint64_t chunk, std::uint64_t lie_step,
                                        const Lie& lie);

}  // namespace tumble::golden
