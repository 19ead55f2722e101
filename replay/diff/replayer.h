#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "replay/diff/divergence.h"
#include "replay/format/progress.h"
#include "replay/log/log_reader.h"
#include "src/base/result.h"
#include "src/world/world.h"

namespace tumble::replay {

struct ReplayOptions {
  /// Compare from the state after this step on; the log's first state or less replays all. The keyframe at or before it
  /// is trusted.
  std::uint64_t from_step = 0;
  Workers* workers = nullptr;  ///< threads to step with; see World::use
};

struct ReplayReport {
  std::uint64_t steps = 0;          ///< compared
  std::optional<Divergence> first;  ///< none: identical to the bit, the last step included
  Hash128 final_hash;               ///< state hash of the last state this build computed
  std::vector<std::string> notes;   ///< for people: another method version, phases that cannot be compared, a torn end
  [[nodiscard]] bool identical() const { return !first.has_value(); }
};

/// Replays a log and compares every step with it, the last included: dt and inputs, phase words, state hash, counters;
/// where they differ, the states say body and field. (That a log's states are those its state hashes tell of is
/// verify()'s matter.) Where a chunk ends, the hidden state is compared too, by the next keyframe's continuation hash,
/// if this build has the log's method version. From state 0 on, that comes first: the scene must still resolve to it.
/// A session that goes on from another one's state is replayed from its keyframe. Stops at the first difference.
/// Errors: must_be_ours(); a log that cannot be read on (kDamaged, naming the steps compared before), nothing to
/// compare (kDamaged). A step that this build cannot take is a Divergence with the field "error".
Result<ReplayReport> replay_log(LogReader& log, const ReplayOptions& options = {}, const Progress& progress = {});

}  // namespace tumble::replay
