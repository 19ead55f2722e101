#pragma once

#include <functional>

#include "replay/log_reader.h"
#include "replay/measure.h"
#include "replay/recorder.h"
#include "src/base/result.h"

namespace tumble::replay {

/// Measures a whole log, as far as it is whole. States that it does not hold are simulated again, so the result does
/// not depend on `--states`. each_row, if given, is called for state 0 and after every step. Errors: as
/// StateSource::read(); a stop asked for by `progress` (kCannotFinish).
Result<Metrics> measure_log(LogReader& log, const std::function<void(const SeriesRow&)>& each_row = {},
                            const Progress& progress = {});

}  // namespace tumble::replay
