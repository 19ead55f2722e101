#pragma once

#include "golden/canaries/canary_roll.h"

namespace tumble::golden {

/// Logs with one false value, without a part, or continued from the middle. Replay, diff and reading must see each
/// fault, and must see none in an intact log. These canaries are about "format".
void run_log_canaries(CanaryRoll& roll);

}  // namespace tumble::golden
