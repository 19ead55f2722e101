#pragma once

#include <cstdint>

#include "tumble/replay/log_reader.h"
#include "tumble/sim/result.h"

/// `diff --step K`: one step of two logs side by side, phase by phase.
namespace tumble::tools {

/// Compares step k of both and prints the comparison, for people or as JSON. For a log that begins at k, only its first
/// state is compared. Returns whether every bit that both logs hold of the step is equal. Errors: as
/// LogReader::read_step().
Result<bool> print_side_by_side(replay::LogReader& a, replay::LogReader& b, std::uint64_t k, bool as_json);

}  // namespace tumble::tools
