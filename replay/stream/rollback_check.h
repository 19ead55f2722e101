#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "replay/stream/stream_reader.h"
#include "tumble/replay/extras.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// The first step that a rollback took again with equal inputs and another result.
struct RollbackDifference {
  std::uint64_t step = 0;
  std::optional<std::uint64_t> body;
  std::string field;   ///< "position.x", "asleep", "contacts", "phase hashes", "channels", "hashes", "bodies"
  std::string before;  ///< the value that was recorded first; empty where the field is no number
  std::string after;
};

/// A sync test: steps that were recorded twice, because tumble_rec_rewind() took them back, compared. A step counts as
/// compared if its inputs and those of all steps between the rewind and it are as before: the result must then be as
/// before too. Behind the first other input, or the first difference, steps of that rewind are not compared.
struct RollbackCheck {
  std::uint64_t compared = 0;
  std::uint64_t not_compared = 0;
  std::uint64_t different = 0;  ///< rewinds with a difference
  std::optional<RollbackDifference> first;
  /// Each step that was recorded before, in the stream's order, with its number: what the log keeps of it. A step with
  /// other inputs names the first of them; a step behind one says so.
  std::vector<std::pair<std::uint64_t, Superseded>> steps;
};

/// Errors: the stream's.
Result<RollbackCheck> check_rollbacks(const StreamReader& stream);

/// One line: "12 steps were taken again with equal inputs, all with equal results".
std::string describe(const RollbackCheck& check);

}  // namespace tumble::replay
