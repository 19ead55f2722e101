#pragma once

#include <string>
#include <vector>

#include "golden/judge/judge.h"

namespace tumble::golden {

/// A comparison that must fail, and whether it did.
struct CanaryResult {
  std::string name;  ///< what is wrong on purpose: "the last state differs"
  bool caught = false;
  std::string words;            ///< what the judge said
  std::string about = "suite";  ///< what does not work if it is not caught: "suite", or "format" for log and golden
};

/// Records a tiny session, spoils golden, bounds, log or file in one way after the other and lets the judge of the
/// cases look at each. The first canary is a control: nothing is spoilt, and it must pass. Every check runs them; one
/// that is not caught means that no verdict of that check can be trusted.
std::vector<CanaryResult> run_canaries(Judge judge_function = judge);

}  // namespace tumble::golden
