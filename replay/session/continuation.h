#pragma once

#include <cstdint>

#include "replay/format/step_record.h"
#include "replay/log/log_reader.h"
#include "replay/session/recorder.h"
#include "src/base/result.h"
#include "src/world/world_state.h"

namespace tumble::replay {

/// What a session needs to go on from another one's state.
struct Continuation {
  LogHeader header;  ///< of the new log: its scene has the bodies as they are then, and the inputs still to come
  sim::WorldState state;
};

/// State k of a log, and the header of a log that goes on from it. Errors: Recorder::go_on's.
Result<Continuation> continuation_of(LogReader& log, std::uint64_t k, const GoOnOptions& options);

}  // namespace tumble::replay
