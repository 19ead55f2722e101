#pragma once

#include "tools/arguments/live_options.h"
#include "tools/output/exit.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// `tumble live`: opens a window, plays a session in it until it is closed, and completes the log. Errors: bad
/// arguments; no display; a log or a picture that cannot be written or drawn. The log is completed in every case.
Result<Exit> play(const LiveArguments& arguments);

}  // namespace tumble::tools
