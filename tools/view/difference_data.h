#pragma once

#include <string>

#include "tools/output/text.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/progress.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// What `diff` finds between two logs, for the session page: {"state": "done", "identical", "steps", "first", "cause",
/// "aftermath", "notes", "separation": {"step", "metres", "bodies", "body"}, "partings": {"from", "last", "rows":
/// [{"phase", "step", "substep", "steps"}], "why_not"}}. Errors: diff_logs()'s, report_difference()'s.
Result<Json> difference_data(replay::LogReader& a, replay::LogReader& b, const replay::Progress& progress = {});

}  // namespace tumble::tools
