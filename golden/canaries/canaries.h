#pragma once

#include <vector>

#include "tumble/golden/judge.h"
#include "tumble/golden/suite_result.h"

namespace tumble::golden {

/// Records a tiny session, spoils golden, bounds, log or file in one way after the other and judges each as a case. The
/// first canary is a control: nothing is spoilt, and it must pass. Every check runs all canaries; if one is not caught,
/// no verdict of that check can be trusted.
std::vector<CanaryResult> run_canaries(Judge judge_function = judge);

}  // namespace tumble::golden
