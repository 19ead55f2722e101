#pragma once

#include "tumble/sim/result.h"

namespace tumble::process {

/// Makes this process ready to work. From then on a file that reaches the limit of `ulimit -f` is an error of the write
/// that says so, and no end by SIGXFSZ. Errors (kCannotFinish): a stack in which the program cannot run, a current
/// folder that was removed.
Status check_own_limits();

}  // namespace tumble::process
