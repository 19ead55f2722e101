#pragma once

#include <cstdint>
#include <optional>

#include "tumble/replay/log_reader.h"
#include "tumble/replay/player.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// Reads every state of a log, including those that the log does not hold (`--states every:N` and `hashes`). Simulates
/// a missing state again from the keyframe before, and compares its hash with the log's. Quick where steps are read in
/// ascending order.
class StateSource {
 public:
  /// `log` must outlive this object. Others may read from `log` between two calls.
  explicit StateSource(LogReader& log) : log_(&log) {}

  /// Step k of first_state() … last_step() as LogReader::read_step() returns it, always with states. The record lasts
  /// until the next read() and until the next call of a non-const member of the log. Errors: the log's; kCannotFinish
  /// where this build computes a state with another hash.
  Result<const StepRecord*> read(std::uint64_t k);

 private:
  Status simulate(std::uint64_t k);

  LogReader* log_;
  std::optional<Player> player_;
  StepRecord record_;
};

}  // namespace tumble::replay
