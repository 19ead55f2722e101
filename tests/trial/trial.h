#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tumble/sim/result.h"

/// Damage done to logs by the hundred thousand: what tools/scripts/checks/damage.sh runs, and in small the tests.
namespace tumble::trial {

struct Counts {
  std::uint64_t trials = 0;
  std::uint64_t undetected = 0;  ///< damages that a reader did not report, or not where they were done
  std::uint64_t lost = 0;        ///< complete chunks that a reader or a recovery did not have
  std::uint64_t recoveries = 0;
  std::vector<std::string> failures;  ///< the first of them, for people
};

/// Flips bits in a log in memory and cuts it, `trials` times; every 100th is recovered too. Errors: a log that is not
/// whole to begin with.
Result<Counts> flip_and_cut(const std::string& path, std::uint64_t trials, std::uint64_t seed);

/// Records a scene with the program, `count` times, and kills it with SIGKILL at a random instant of the time that it
/// takes; looks at what it left. Errors: the program cannot be run to its end.
Result<Counts> kill_recorders(const std::string& program, const std::string& scene, std::uint64_t count,
                              std::uint64_t seed, const std::string& folder);

}  // namespace tumble::trial
