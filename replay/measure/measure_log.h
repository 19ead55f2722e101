#pragma once

#include <functional>

#include "replay/measure/measure.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/progress.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// Measures all steps that a log can deliver. A recovered log is measured up to its first missing steps, because the
/// changes of energy and bodies in them are not known. States that the log does not hold are simulated again, so the
/// result does not depend on `--states`. each_row, if given, is called for the first measured state and after every
/// later step. Errors: StateSource::read's, Measurer::finish's; kCannotFinish where `progress` stops.
Result<Metrics> measure_log(LogReader& log, const MeasureOptions& options = {},
                            const std::function<void(const SeriesRow&)>& each_row = {}, const Progress& progress = {});

}  // namespace tumble::replay
