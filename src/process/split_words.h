#pragma once

#include <string>
#include <vector>

#include "tumble/sim/result.h"

namespace tumble::process {

/// Splits a command line at spaces, with a shell's quotes and backslashes and nothing else of a shell. Errors
/// (kBadInput): a quote without its end, no word.
Result<std::vector<std::string>> split_words(const std::string& command);

}  // namespace tumble::process
