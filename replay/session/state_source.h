#pragma once

#include <cstdint>
#include <optional>

#include "replay/diff/replayer.h"
#include "replay/format/step_record.h"
#include "replay/log/log_reader.h"
#include "src/base/result.h"

namespace tumble::replay {

/// Every state of a log, also those that it does not hold (`--states every:N` and `hashes`): they are simulated again
/// from the keyframe before and must have the log's state hash. Quick where steps are asked for in ascending order.
class StateSource {
 public:
  /// log must outlive this, and may be read from in between.
  explicit StateSource(LogReader& log) : log_(&log) {}

  /// Step k of first_state() … last_step() as LogReader::read_step() gives it, always with states. Good until the next
  /// call of this or of a member of the log that is not const. Errors: the log's; kCannotFinish where this build
  /// computes another state than the log's.
  Result<const StepRecord*> read(std::uint64_t k);

 private:
  Status simulate(std::uint64_t k);

  LogReader* log_;
  std::optional<Player> player_;
  StepRecord record_;
};

}  // namespace tumble::replay
