#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "replay/diff/separation.h"
#include "replay/measure/measure.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/progress.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// One metric in two sessions.
struct MovedMetric {
  std::string name;
  std::string unit;
  std::optional<double> a;
  std::optional<double> b;
};

/// The growth of a first difference, up to the last step that both sessions have.
struct DivergenceGrowth {
  Separation separation;
  std::vector<MovedMetric> metrics;  ///< those that differ, over the whole sessions
  std::string not_measured;          ///< the reason why metrics are not compared; empty: they are
};

/// Follows two logs from their first different step on, then measures both from their start, neither behind step
/// `until`: three passes, each of which `progress` counts from 0. Errors: measure_separation()'s, StateSource::read's.
Result<DivergenceGrowth> growth_between(LogReader& a, LogReader& b, std::uint64_t first_difference,
                                        const Progress& progress = {}, std::uint64_t until = ~std::uint64_t{0});

/// Follows a log and this build's replay of it, which first differs in step `first_difference` and starts from the
/// log's state before; that must be a step after its first state. `again` is the same log opened a second time. Errors:
/// likewise; a step that this build cannot take.
Result<DivergenceGrowth> growth_in_replay(LogReader& log, LogReader& again, std::uint64_t first_difference,
                                          const Progress& progress = {});

/// The metrics that differ, over all bodies. Values within a billionth of each other count as equal, because metrics
/// are computed with the C library's trigonometry, which differs between systems.
std::vector<MovedMetric> moved_metrics(const Metrics& a, const Metrics& b);

}  // namespace tumble::replay
