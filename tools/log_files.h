#pragma once

#include "replay/log_reader.h"
#include "tools/command.h"

namespace tumble::tools {

/// The exit status of a command that has read what `log` still holds: `verdict` for a whole log; kDamaged, and a line
/// on stderr that says what is wrong, for one that is torn or damaged.
Exit judge(const char* command, const replay::LogReader& log, Exit verdict);

}  // namespace tumble::tools
