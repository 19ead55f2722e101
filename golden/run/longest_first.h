#pragma once

#include <vector>

#include "tumble/golden/suite.h"

namespace tumble::golden {

/// Puts cases with the most body-steps first: a long case that starts last would keep one processor busy alone.
std::vector<CaseFolder> longest_first(std::vector<CaseFolder> folders);

}  // namespace tumble::golden
