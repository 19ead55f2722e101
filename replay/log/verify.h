#pragma once

#include <cstdint>

#include "replay/log/log_reader.h"

namespace tumble::replay {

struct VerifyReport {
  LogCondition condition;           ///< everything found
  std::uint64_t steps_checked = 0;  ///< read, decoded and hashed again
  std::uint64_t states_checked = 0;
};

/// Reads every byte of a log and checks all it can: stored hashes, chain, steps without a gap, states against their
/// state hashes, each keyframe against the step before it (and its continuation hash where this build has the log's
/// method version), the index against the file, the footer, bytes that belong to no record.
VerifyReport verify(LogReader& log);

}  // namespace tumble::replay
