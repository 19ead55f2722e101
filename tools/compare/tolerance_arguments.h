#pragma once

#include <string>
#include <vector>

#include "tumble/replay/log_reader.h"
#include "tumble/replay/tolerance.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// The tolerances of `--tolerance FIELD=V` for a comparison of two logs. Errors (kBadInput): no number, no such field,
/// a channel that is not a channel of numbers in both logs.
Result<replay::Tolerances> parse_tolerances(const std::vector<std::string>& arguments, const replay::LogReader& a,
                                            const replay::LogReader& b);

}  // namespace tumble::tools
