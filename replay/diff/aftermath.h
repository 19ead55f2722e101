#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "replay/diff/gap_story.h"
#include "replay/format/progress.h"
#include "replay/log/log_reader.h"
#include "src/base/result.h"

namespace tumble::replay {

/// What a first difference led to, up to the last step that both sessions have.
struct Aftermath {
  GapStory gap;
  std::vector<MovedMetric> metrics;  ///< that moved, over the whole sessions
  std::string not_measured;          ///< why metrics are not compared; empty: they are
};

/// Of two logs, from the step on in which they first differ. Errors: as tell_story() and StateSource::read().
Result<Aftermath> aftermath_of(LogReader& a, LogReader& b, std::uint64_t first_difference,
                               const Progress& progress = {});

/// Of a log and what this build makes of it, which differs from it first in a step of the log's own. `again` is the
/// same log, opened a second time. Errors: likewise; a step that this build cannot take.
Result<Aftermath> aftermath_of_replay(LogReader& log, LogReader& again, std::uint64_t first_difference,
                                      const Progress& progress = {});

}  // namespace tumble::replay
