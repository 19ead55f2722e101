#pragma once

#include <string>

#include "tools/arguments/command.h"
#include "tumble/sim/result.h"

namespace tumble::tools::bisect {

/// Prints the first difference of two logs, found by halving, and the facts that a repeated step adds. Errors:
/// open_log's, diff_and_locate's; kCannotFinish if interrupted. shared: data that one log alone has is no difference.
Result<Exit> locate_in_logs(const std::string& path_a, const std::string& path_b, bool json_wanted, bool shared);

}  // namespace tumble::tools::bisect
