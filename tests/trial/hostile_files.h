#pragma once

#include <string>
#include <vector>

#include "src/base/result.h"

/// Small files made to fill the memory of who reads them.
namespace tumble::trial {

/// Writes them into a folder that exists; returns their paths. Logs say what limits.h lets pass at most, and more;
/// hashes and chains are right, so that a reader goes on to what lies behind them.
Result<std::vector<std::string>> make_hostile_files(const std::string& folder);

}  // namespace tumble::trial
