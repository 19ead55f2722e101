#pragma once

#include <cstdint>

#include "tumble/replay/log_reader.h"

namespace tumble::replay {

struct VerifyReport {
  LogCondition condition;            ///< with all damage found
  std::uint64_t steps_checked = 0;   ///< decoded, and added to the chain again
  std::uint64_t states_checked = 0;  ///< steps whose states were hashed again
};

/// Reads every byte of a log and checks:
/// - the stored hash of each record, the chain, and that no step is missing
/// - states against their state hashes
/// - each keyframe against the step before it, and against its continuation hash if this build has the log's method
///   version
/// - the index against the file, the footer, and that no byte lies outside a record
VerifyReport verify(LogReader& log);

}  // namespace tumble::replay
