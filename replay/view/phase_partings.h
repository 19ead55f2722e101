#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tumble/replay/log_reader.h"
#include "tumble/replay/progress.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// Where the hashes of one phase of two sessions part.
struct PhaseParting {
  std::string phase;
  std::optional<std::uint64_t> step;  ///< the first with another hash; none: equal in all steps that were read
  std::uint32_t substep = 0;          ///< of that step, 0-based
  std::uint64_t steps = 0;            ///< steps with another hash
};

struct PhasePartings {
  std::uint64_t from = 0, last = 0;  ///< the steps that were read
  std::vector<PhaseParting> phases;  ///< in the order in which the phases run
};

/// Compares the phase hashes of steps from … the last of both, where both hold them. Errors: those of reading;
/// kBadInput where phase hashes of the two mean different things, or one holds none; kCannotFinish where `progress`
/// stops.
Result<PhasePartings> phase_partings(LogReader& a, LogReader& b, std::uint64_t from, const Progress& progress = {});

}  // namespace tumble::replay
