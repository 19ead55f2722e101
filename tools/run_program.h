#pragma once

#include <string>
#include <vector>

#include "tools/output/exit.h"

namespace tumble::tools {

/// The program `tumble` in one call: finds the command, reads its arguments, runs it and turns what came of it into an
/// exit status. Results go to std::cout, errors to std::cerr; nothing is thrown.
/// arguments: those after the program's name
Exit run_program(std::vector<std::string> arguments);

}  // namespace tumble::tools
