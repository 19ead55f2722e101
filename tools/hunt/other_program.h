#pragma once

#include <string>

#include "tumble/sim/result.h"

namespace tumble::tools {

/// Whether `hunt --against` can record with the program: it starts, and answers --version with "tumble …". Errors
/// (kBadInput): what was found, as missing, a folder, no executable file, a crash, no answer in a minute, another
/// program.
Status check_other_program(const std::string& program);

}  // namespace tumble::tools
