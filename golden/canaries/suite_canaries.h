#pragma once

#include <vector>

#include "tumble/golden/suite_result.h"

namespace tumble::golden {

/// Checks the adding up of verdicts: no case is left out, no failure becomes a success.
std::vector<CanaryResult> run_suite_canaries();

}  // namespace tumble::golden
