#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "replay/format/progress.h"
#include "replay/log/log_reader.h"
#include "src/base/hash.h"

namespace tumble::replay {

/// What a log holds, counted over the steps that can be read.
struct LogFacts {
  std::uint64_t bodies_at_start = 0;
  std::uint64_t bodies_thrown = 0;
  std::uint64_t steps_read = 0;
  double seconds = 0;                              ///< simulated
  std::map<std::string, std::uint64_t> inputs;     ///< by kind: "throw", "push", …
  std::optional<std::uint64_t> moving_body_steps;  ///< bodies neither frozen nor static, summed over the steps; none
                                                   ///< where the log does not hold every state
  std::optional<Hash128> final_hash;               ///< state hash of the last step that can be read

  /// Bytes of the whole file for each of moving_body_steps; none where nothing moves or it is not known.
  [[nodiscard]] std::optional<double> bytes_per_moving_body_step(std::uint64_t file_bytes) const;
};

/// Reads a log from end to end. Steps that cannot be read are left out: verify() names them.
LogFacts collect_facts(LogReader& log, const Progress& progress = {});

}  // namespace tumble::replay
