#pragma once

#include <vector>

#include "golden/judge/suite_result.h"

namespace tumble::golden {

/// What a check does with verdicts that it has: nothing is left out, no failure adds up to a success.
std::vector<CanaryResult> run_suite_canaries();

}  // namespace tumble::golden
