#pragma once

#include <optional>

#include "golden/expected/expected.h"
#include "golden/judge/case_result.h"
#include "golden/suite/case_rules.h"
#include "replay/log/log_reader.h"
#include "src/base/result.h"

namespace tumble::golden {

/// What a session is judged by. References must outlive the call.
struct Reference {
  const CaseRules& rules;
  const Expected* expected = nullptr;  ///< null: there is none, which fails
  Hash128 scene;                       ///< scene_hash() of scene.toml as it is now
  Hash128 continuation;                ///< of the last state; zero where it is not known
};

/// What a session turned out to be, apart from its verdicts.
struct Judged {
  CaseResult result;  ///< verdicts, problems, metrics, difference, steps, bodies, final hash; the rest is the caller's
  Expected actual;    ///< what a golden of this session would be
  std::vector<std::optional<double>> values;  ///< of the rules' metrics, in their order; empty if it was not measured
};

/// Reads a session's log from state 0 to its last step, compares every one of them with the golden and measures it.
/// Nothing here throws away a failure: a log that cannot be read on becomes a problem of the result.
Judged judge(replay::LogReader& log, const Reference& reference);

/// The same kind of function as judge(): canaries use it to prove that a judge sees what it must.
using Judge = Judged (*)(replay::LogReader& log, const Reference& reference);

}  // namespace tumble::golden
