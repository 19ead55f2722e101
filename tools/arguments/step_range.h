#pragma once

#include <cstdint>
#include <string>

#include "tumble/replay/log_reader.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// Steps first … last of a log, both included.
struct StepRange {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
};

/// `--steps A:B`. Errors: kBadInput for another form or steps that the log never held; kDamaged where it is torn.
Result<StepRange> parse_range(const std::string& text, const replay::LogReader& log);

/// Checks a known range against a log. Errors: steps that the log does not hold.
Result<StepRange> check_range(const StepRange& range, const replay::LogReader& log);

}  // namespace tumble::tools
