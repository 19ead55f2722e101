#pragma once

#include <cstdint>
#include <optional>

#include "replay/diff/separation.h"
#include "tools/output/text.h"
#include "tumble/replay/log_reader.h"
#include "tumble/sim/result.h"

/// Steps of a session as times, s from its first state on.
namespace tumble::tools {

/// The last step of both sessions that ends within `seconds` of the first state of the log that begins first;
/// replay::kNoLimit where both end before. Errors: a log with steps, none of which ends by then (kBadInput); a step
/// that cannot be read.
Result<std::uint64_t> step_until(replay::LogReader& a, replay::LogReader& b, double seconds);

/// The time at which step k ends; 0 at the first state. Errors: likewise.
Result<double> time_of(replay::LogReader& log, std::uint64_t k);

/// The first step in which two sessions were apart by more than a bound.
struct Parting {
  double beyond = 0;  ///< m
  std::uint64_t step = 0;
  double time = 0;  ///< s, the end of that step
  std::optional<std::uint64_t> body;
};

/// None: in no step up to `last`. Errors: a step of `log` that cannot be read.
Result<std::optional<Parting>> find_parting(replay::LogReader& log, const replay::Separation& separation, double beyond,
                                            std::uint64_t last);

/// all_measured: no body exists in one of the two sessions only.
void print_parting(const std::optional<Parting>& parting, double beyond, std::uint64_t last, bool all_measured);
Json parting_json(const std::optional<Parting>& parting, double beyond);

}  // namespace tumble::tools
