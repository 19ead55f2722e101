#pragma once

#include <string>
#include <vector>

#include "tools/manual/manual_entry.h"

namespace tumble::tools {

/// The manual page of one command (section 1) in the macros of man(7): tumble-record.1.
std::string man_page(const ManualEntry& command, const std::string& version);

/// The manual page of the program, which lists the commands: tumble.1.
std::string man_page_of_program(const std::vector<ManualEntry>& commands, const std::string& version);

}  // namespace tumble::tools
