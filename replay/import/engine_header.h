#pragma once

#include <cstdint>

#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

/// Parts of the header of another engine's log.
namespace tumble::replay {

/// Errors (kBadInput): no name, an unknown precision.
Status check_engine(const EngineName& engine);

/// Makes the log one of the last steps of a session: a continued log, whose beginning nobody kept.
void begin_at(std::uint64_t step, LogHeader& header, sim::WorldState& state);

}  // namespace tumble::replay
