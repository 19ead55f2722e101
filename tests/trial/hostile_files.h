#pragma once

#include <string>
#include <vector>

#include "tumble/sim/result.h"

/// Small files made to fill the memory of who reads them.
namespace tumble::trial {

/// Writes logs (hostile_logs.h), tables and scenes into a folder that exists; returns their paths.
Result<std::vector<std::string>> make_hostile_files(const std::string& folder);

}  // namespace tumble::trial
