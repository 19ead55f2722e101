#pragma once

#include "replay/log/log_reader.h"
#include "src/base/result.h"
#include "tools/output/text.h"

/// `diff --step K`: one step of two logs side by side, phase by phase.
namespace tumble::tools {

struct SideBySide {
  bool same = false;  ///< in every bit that both logs hold of it
  Json json;          ///< for `--json`
};

/// Compares step k of both. For a log that begins at k, only its first state is compared. Errors: as
/// LogReader::read_step().
Result<SideBySide> step_side_by_side(replay::LogReader& a, replay::LogReader& b, std::uint64_t k);

/// Prints the comparison for people.
void print_side_by_side(const SideBySide& step);

}  // namespace tumble::tools
