#pragma once

#include <vector>

#include "golden/judge/suite_result.h"

namespace tumble::golden {

/// Sessions whose logs lie in one value, lose a part or go on from the middle: replay, diff and reading must see it,
/// and must see nothing where there is nothing. What they say is about "format".
std::vector<CanaryResult> run_log_canaries();

}  // namespace tumble::golden
