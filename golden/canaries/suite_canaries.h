#pragma once

#include "golden/canaries/canary_roll.h"

namespace tumble::golden {

/// Checks the adding up of verdicts: no case is left out, no failure becomes a success.
void run_suite_canaries(CanaryRoll& roll);

}  // namespace tumble::golden
