#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "golden/run/case_run.h"
#include "golden/run/run_session.h"

namespace tumble::golden {

/// Files of a failed case in a report, beside pictures and series.json.
inline constexpr const char* kLogFile = "actual.tumble";
inline constexpr const char* kTrackFile = "expected_track.csv";

/// Writes the files of a failed case into its folder of the report, and names them in its result; what cannot be
/// written becomes a problem.
void leave_case_files(CaseRun& run, const std::filesystem::path& report, const Session& session, replay::LogReader& log,
                      const std::optional<Expected>& expected);

}  // namespace tumble::golden
