#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tumble/replay/comparison_scope.h"
#include "tumble/replay/divergence.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/progress.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world.h"

namespace tumble::replay {

struct ReplayOptions {
  /// Compare from the state after this step on; the log's first state or less replays all. The keyframe at or before
  /// this step is trusted.
  std::uint64_t from_step = 0;
  Workers* workers = nullptr;  ///< threads to step with; null: the caller's alone
};

struct ReplayReport {
  std::uint64_t steps = 0;          ///< compared
  std::optional<Divergence> first;  ///< none: every step is equal to the bit
  Hash128 final_hash;               ///< state hash of the last state that this build computed
  std::vector<std::string>
      notes;  ///< for people: another method version, phases that cannot be compared, a log that is not whole
  ComparisonScope scope;
  [[nodiscard]] bool identical() const { return !first.has_value(); }
};

/// Replays a log and compares every step with this build's, up to and including the last: dt and inputs, phase words,
/// state hash, counters. Where they differ, the states give body and field. Before, the world that this build makes of
/// the log's scene is compared with the log's first keyframe, property by property: parameters, sizes, masses,
/// inertias, materials, states, hidden state. At the end of a chunk the replayed world is compared with the next
/// keyframe likewise. Hidden state is compared only if this build has the log's method version; the scene of a
/// continued log has no hidden and no visible state to compare. The report's scope says so. Stops at the first
/// difference. (verify() checks that the states of a log match their hashes.) Errors: must_be_ours(); a log that cannot
/// be read on (kDamaged; the message names the steps compared before); kCannotFinish where `progress` stops. A step
/// that this build cannot take is a Divergence with the field "error".
Result<ReplayReport> replay_log(LogReader& log, const ReplayOptions& options = {}, const Progress& progress = {});

}  // namespace tumble::replay
