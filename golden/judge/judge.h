#pragma once

#include <optional>
#include <string_view>

#include "tumble/golden/case_result.h"
#include "tumble/golden/case_rules.h"
#include "tumble/golden/expected.h"
#include "tumble/replay/log_reader.h"
#include "tumble/sim/result.h"

namespace tumble::golden {

/// A session is judged by these. References must outlive the call.
struct Reference {
  const CaseRules& rules;
  const Expected* expected = nullptr;  ///< null: there is none, which fails
  Hash128 scene;                       ///< scene_hash() of scene.toml as it is now
  Hash128 continuation;                ///< of the last state; zero where it is not known
  std::string_view scene_text = {};    ///< of scene.toml as it is now: names the lines that changed
  bool cut_short = false;              ///< the session failed, and the caller says so: its length is no problem
};

/// A judged session.
struct Judged {
  CaseResult result;  ///< verdicts, problems, metrics, difference, steps, bodies, final hash; the rest is the caller's
  Expected actual;    ///< a new golden of this session
  std::vector<std::optional<double>> values;  ///< of the rules' metrics, in their order; empty if it was not measured
};

/// Reads a session's log from state 0 to its last step, compares each step with the golden and measures the session. A
/// log that cannot be read to its end becomes a problem of the result.
Judged judge(replay::LogReader& log, const Reference& reference);

/// A function like judge(). Tests give the canaries a bad one, to show that the canaries notice.
using Judge = Judged (*)(replay::LogReader& log, const Reference& reference);

}  // namespace tumble::golden
