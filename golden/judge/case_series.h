#pragma once

#include "golden/judge/case_json.h"
#include "tumble/golden/expected.h"
#include "tumble/replay/log_reader.h"
#include "tumble/sim/result.h"

namespace tumble::golden {

/// The file of these numbers in a failed case's folder of the report.
inline constexpr const char* kSeriesFile = "series.json";

/// The numbers that index.html draws for a failed case: numbers and nulls under fixed names, never a word of the scene
/// but the names and units of channels (channel_series.h).
///   actual    a column each of step, kinetic, potential, total (J), lateral_max, column_spread, height_max,
///   height_mean
///             (m), a row a state; every n-th of a long session
///   expected  track: the same where the coarse track has them, potential of the energies; states: step and the three
///             energies, where the golden has full states. Millimetres: the track keeps no more
///   bodies    id and size (x, y, z in m, one after the other; 0 where unknown) of every body of frames
///   frames    step, and a row a step of expected_mm and actual_mm (x, y, z a body, null where it is not there) and
///             actual_turn (w, x, y, z a body)
/// expected: null where there is none. Errors: a log that cannot be read.
Result<Json> case_series(replay::LogReader& log, const Expected* expected);

}  // namespace tumble::golden
