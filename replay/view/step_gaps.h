#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tumble/replay/log_reader.h"

namespace tumble::replay {

/// A run of steps that a log does not hold, between others.
struct StepGap {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
  std::string why;  ///< for people: "lost before the log was recovered", "in a damaged record"
};

/// The gaps between the intact chunks of a log, by step. Damage inside a chunk shows only when the chunk is read.
std::vector<StepGap> step_gaps(const LogReader& log);

}  // namespace tumble::replay
