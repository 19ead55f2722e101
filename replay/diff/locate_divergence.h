#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "replay/diff/step_contacts.h"
#include "tumble/replay/compare.h"
#include "tumble/replay/divergence.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/progress.h"

namespace tumble::replay {

/// The first different step of two sessions, taken again by this build from the state before it.
struct DivergenceLocation {
  /// This build took the step again, from one log at least. Never of another engine's step or of a first state.
  bool taken = false;
  // Whether this build's step matches the log.
  bool as_a = false;
  bool as_b = false;
  /// The reason why the step could not be taken again; empty: it was, or there was nothing to take.
  std::string not_taken;
  /// The contacts of the first different body in that step, as this build computes them from the log that it matches
  /// (from the first log if it matches both or neither).
  std::vector<StepContact> contacts;
  /// The bodies whose states differ after that step, ascending; empty where a log has no such states and this build
  /// cannot make them.
  std::vector<sim::BodyId> bodies;
};

/// Takes the first different step again from both logs. Completes `first`: the pair where it is plain, body and field
/// in place of a hash where the logs hold no states.
DivergenceLocation locate_divergence(LogReader& a, LogReader& b, Divergence& first);

/// The location of the first difference between a log and this build's replay of it. Side b is this build and is left
/// out: as_b stays false. Completes the pair of `first` where the log holds states. Requires a step after the log's
/// first state.
DivergenceLocation locate_in_replay(LogReader& log, Divergence& first);

/// diff_logs() and locate_divergence() in one call.
struct LocatedDivergence {
  DiffReport report;  ///< with `first` completed
  DivergenceLocation location;
  std::uint64_t chunks_opened = 0;  ///< decoded, of both logs
};

/// Compares two logs exactly and locates their first difference. Errors: as diff_logs().
Result<LocatedDivergence> diff_and_locate(LogReader& a, LogReader& b, const Progress& progress = {});

}  // namespace tumble::replay
