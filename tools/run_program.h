#pragma once

#include <string>
#include <vector>

#include "tools/arguments/command.h"
#include "tools/output/exit.h"

namespace tumble::tools {

/// The program `tumble` in one call: finds the command, reads its arguments, runs it and returns its exit status.
/// Results go to std::cout, errors to std::cerr; no exception leaves. arguments: those after the program's name
Exit run_program(std::vector<std::string> arguments);

/// One command by itself, for a program that has no other. words: those after the program's name.
Exit run_command(const Command& command, const std::vector<std::string>& words);

}  // namespace tumble::tools
