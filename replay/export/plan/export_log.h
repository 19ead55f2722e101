#pragma once

#include "replay/export/plan/export_plan.h"
#include "replay/export/plan/export_writer.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/progress.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// Reads the states of the plan in one pass and hands them to the writer. States that the log leaves out are computed
/// again. Errors: the log's, the writer's; kCannotFinish where `progress` stops.
Status export_log(LogReader& log, const ExportPlan& plan, ExportWriter& writer, const Progress& progress = {});

}  // namespace tumble::replay
