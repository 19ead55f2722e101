#pragma once

#include <filesystem>
#include <string>

#include "golden/run/case_run.h"

namespace tumble::golden {

/// The reason why `bless` would refuse a case that was run; empty if it would accept it. rules: the path of its
/// metrics.toml, for the message.
std::string obstacle_to_bless(const CaseRun& run, const std::filesystem::path& rules);

}  // namespace tumble::golden
