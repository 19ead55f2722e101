#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "replay/format/not_finite.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/progress.h"
#include "tumble/sim/hash.h"

namespace tumble::replay {

/// The hash of the complete state that a chunk begins with, as the log holds it.
struct KeyframeHash {
  std::uint64_t step = 0;
  Hash128 continuation_hash;
};

struct VerifyReport {
  LogCondition condition;                      ///< with all damage found
  std::uint64_t steps_checked = 0;             ///< decoded, and added to the chain again
  std::uint64_t states_checked = 0;            ///< steps whose states were hashed again
  std::optional<NotFinite> lost;               ///< no damage: another engine's states may hold any double
  std::vector<KeyframeHash> keyframes;         ///< by step
  std::optional<std::uint64_t> contacts_from;  ///< of another engine: the first state or step with one
  bool complete = true;  ///< false: `progress` stopped the check, and the report covers a part of the log
  [[nodiscard]] bool has_contacts_by(std::uint64_t step) const { return contacts_from && *contacts_from <= step; }
};

/// Reads every byte of a log and checks:
/// - the stored hash of each record, the chain, and that no step is missing
/// - states against their state hashes
/// - each keyframe against the step before it, and against its continuation hash if this build has the log's method
///   version
/// - the index against the file, the footer, and that no byte lies outside a record
VerifyReport verify(LogReader& log, const Progress& progress = {});

}  // namespace tumble::replay
