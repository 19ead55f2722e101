#pragma once

#include <functional>

#include "src/process/child.h"
#include "tumble/sim/result.h"

namespace tumble::process {

/// Called many times a second while a child runs; true ends the child. May be empty.
using Cancel = std::function<bool()>;

/// Runs a program to its end. Files out and err are emptied first. timeout_s: the program is ended after that long; 0:
/// never. Once `cancel` says so or time is over, it gets SIGTERM, and five seconds later SIGKILL: its whole group where
/// it has one of its own. A group of its own is also killed once we are, by whatever signal (Linux). Errors
/// (kCannotFinish): it does not start, files that cannot be written.
Result<ChildEnd> run_child(const Program& program, double timeout_s = 0, const Cancel& cancel = {});

}  // namespace tumble::process
