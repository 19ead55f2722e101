#pragma once

#include <cstdint>
#include <optional>

#include "tumble/replay/log_reader.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::replay {

/// Options for a session that continues another one from one of its states.
struct GoOnOptions {
  StatesMode states;
  HashesMode hashes = {};
  std::optional<std::uint64_t> steps = std::nullopt;  ///< planned after that state; none: up to the other's planned end
  std::optional<double> seconds = std::nullopt;       ///< `steps` given as s, at the dt in force at that state
  bool keep_inputs = true;    ///< apply the inputs that the other log and its scene have after that state
  bool planned_only = false;  ///< of those inputs only the scene's, without the ones that were made live
};

/// The start of a session that continues another one.
struct Continuation {
  LogHeader header;       ///< of the new log; its scene has the bodies of `state` and the inputs still to come
  sim::WorldState state;  ///< the state of the other log, to the bit
};

/// Reads state k of a log and makes the header of a log that continues from it. Errors: Recorder::go_on's.
Result<Continuation> continuation_of(LogReader& log, std::uint64_t k, const GoOnOptions& options);

}  // namespace tumble::replay
