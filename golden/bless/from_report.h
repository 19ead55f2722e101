#pragma once

#include <filesystem>

#include "golden/run/recorded_case.h"
#include "tumble/sim/result.h"

namespace tumble::golden {

/// The sessions that the report of a check elsewhere holds, by the name of their case: those of its failed cases.
/// Errors (kBadInput): no report.json in the folder, or not one of a check; a report of another commit than this
/// program was built at, or of sources that were changed, or one that does not say; a report without a session.
Result<RecordedCases> open_report(const std::filesystem::path& folder);

}  // namespace tumble::golden
