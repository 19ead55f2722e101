#pragma once

#include <string>
#include <vector>

#include "golden/judge/case_result.h"

namespace tumble::golden {

/// A command line that a person may want next, and what for.
struct NextCommand {
  std::string purpose;
  std::string line;
};

/// What to do about a failed case, each to be copied into a shell as it is. A case whose process crashed has none to
/// bless it; only the folder `golden` of a clone can be bisected. suite: the folder, as it was given to the check.
std::vector<NextCommand> next_commands(const CaseResult& result, const std::string& suite);

}  // namespace tumble::golden
