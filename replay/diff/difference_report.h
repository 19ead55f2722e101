#pragma once

#include <optional>
#include <string>

#include "replay/diff/divergence_growth.h"
#include "replay/diff/locate_divergence.h"
#include "tumble/replay/divergence.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/progress.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// Everything known of the first difference between two sessions: `diff`, `replay` and `bisect` print this report.
struct DifferenceReport {
  Divergence first;  ///< with body, field and pair, where they could be found
  /// For people: the first input, parameter or property that differs, "material.friction: 0.4 → 0.400001"; else the
  /// phase that two builds compute otherwise.
  std::string cause;
  /// The first difference in the state of a body: `first` itself, or what followed from it. None: in no state.
  std::optional<Divergence> effect;
  DivergenceLocation location;
  std::optional<DivergenceGrowth> growth;
  std::string growth_unknown;  ///< the reason why there is no growth; may be empty for a replay
};

/// Reports the first difference that diff_logs() found between two logs; found.first must be there. Errors (kDamaged):
/// states of a whole log that do not match its hashes. Other failures leave their part of the report out and give the
/// reason in it.
Result<DifferenceReport> report_difference(LogReader& a, LogReader& b, const DiffReport& found,
                                           const Progress& progress = {});

/// The cause of a first difference between two logs, for people.
std::string cause_of(const DiffReport& found, const Divergence& first);

/// Reports the first difference that replay_log() found. `again` is the same log opened a second time; null leaves
/// growth out.
DifferenceReport report_replay_difference(LogReader& log, LogReader* again, Divergence first,
                                          const Progress& progress = {});

/// The axes of both sessions' tables where these are the same, else ours. Lengths stay in m.
EngineAxes common_axes(const LogHeader& a, const LogHeader& b);

/// A difference in the axes and the unit of the sessions' table: its field, and both values. Other fields stay.
Divergence in_axes(const EngineAxes& axes, Divergence difference);

/// Likewise the field of a body that is lost.
LostBody in_axes(const EngineAxes& axes, LostBody lost);

/// Names everything in a comparison of two logs by common_axes(), with a note that says so: headers, the first
/// difference, the effect, the cause. Every command that prints a difference calls this, so that all name one field
/// alike. report: of `found`, or null.
void name_by_own_axes(const LogHeader& a, const LogHeader& b, DiffReport& found, DifferenceReport* report);

}  // namespace tumble::replay
