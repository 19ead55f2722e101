#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/manual/manual_entry.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// The shells that completion() writes for.
inline constexpr std::string_view kShells[] = {"bash", "zsh", "fish"};

/// A script that completes commands, options and file names in a shell. Errors (kBadInput): another shell.
Result<std::string> completion(const std::vector<ManualEntry>& commands, const std::string& shell);

}  // namespace tumble::tools
