#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/fuzz/mend.h"

namespace tumble::trial {

/// Logs made to fill the memory, by the names of their files: they say what limits.h lets pass at most, and more.
/// Hashes and chains are right, so that a reader goes on to what lies behind them.
std::vector<std::pair<std::string, fuzz::Bytes>> make_hostile_logs();

}  // namespace tumble::trial
