#pragma once

#include <vector>

#include "golden/suite/suite.h"

namespace tumble::golden {

/// Cases with the most body-steps first, so that no long one is left over at the end.
std::vector<CaseFolder> longest_first(std::vector<CaseFolder> folders);

}  // namespace tumble::golden
