#pragma once

#include <functional>

#include "replay/format/progress.h"
#include "replay/log/log_reader.h"
#include "replay/measure/measure.h"
#include "src/base/result.h"

namespace tumble::replay {

/// Measures a whole log, as far as it is whole; a recovered one up to its first gap, because what happened there to
/// energy and bodies is not known. States that it does not hold are simulated again, so the result does
/// not depend on `--states`. each_row, if given, is called for the state that is measured from and after every step.
/// Errors: as StateSource::read() and Measurer::finish(); a stop asked for by `progress` (kCannotFinish).
Result<Metrics> measure_log(LogReader& log, const MeasureOptions& options = {},
                            const std::function<void(const SeriesRow&)>& each_row = {}, const Progress& progress = {});

}  // namespace tumble::replay
