#pragma once

#include <memory>

#include "replay/log/byte_memory.h"
#include "tumble/replay/log_reader.h"

namespace tumble::fuzz {

inline constexpr std::uint64_t kStepsSimulated = 64;  ///< enough to come through every phase

/// Whether steps of this log are simulated in a moment: few bodies and substeps, and more are more of the same.
bool takes_a_moment(const replay::LogReader& log);

/// Opens a log, if it is one, and does with it all that a program may: reads every step, verifies, recovers, measures,
/// replays.
void use_log(const replay::MemoryFile& file);

}  // namespace tumble::fuzz
