#pragma once

#include <string>
#include <vector>

#include "tumble/golden/case_result.h"

namespace tumble::golden {

/// A command line that a person may want next, and its purpose.
struct NextCommand {
  std::string purpose;
  std::string line;
};

/// Commands for a failed case, each ready to be copied into a shell. A case whose process crashed has no command to
/// bless it; only the folder `golden` of a clone can be bisected. suite: the folder, as given to the check.
std::vector<NextCommand> next_commands(const CaseResult& result, const std::string& suite);

/// The folder that commands of a report work from: the one that the check ran in.
std::string current_folder();

}  // namespace tumble::golden
