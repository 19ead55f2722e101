#pragma once

#include "replay/log/log_reader.h"
#include "src/base/result.h"
#include "tools/output/text.h"

/// `diff --step K`: one step of two logs side by side, phase by phase.
namespace tumble::tools {

struct StepBeside {
  bool same = false;  ///< in every bit that both logs hold of it
  Json json;          ///< for `--json`
};

/// Looks at step K of both, which is its start for a log that begins there. Errors: as LogReader::read_step().
Result<StepBeside> look_at_step(replay::LogReader& a, replay::LogReader& b, std::uint64_t k);

/// The same for people.
void print_step_beside(const StepBeside& beside);

}  // namespace tumble::tools
