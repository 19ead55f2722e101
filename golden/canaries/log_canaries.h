#pragma once

#include <vector>

#include "tumble/golden/suite_result.h"

namespace tumble::golden {

/// Logs with one false value, without a part, or continued from the middle. Replay, diff and reading must see each
/// fault, and must see none in an intact log. These canaries are about "format".
std::vector<CanaryResult> run_log_canaries();

}  // namespace tumble::golden
