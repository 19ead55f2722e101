#pragma once

#include <filesystem>
#include <string>

#include "tumble/golden/suite_result.h"
#include "tumble/sim/result.h"

/// A check's results as files: report.json for programs, junit.xml for CI, index.html for people.
namespace tumble::golden {

/// Writes all three into a folder, which is made. junit: another place for junit.xml; empty: into the folder. Errors
/// (kCannotFinish): a file that cannot be written.
Status write_reports(const SuiteResult& result, const std::filesystem::path& folder,
                     const std::filesystem::path& junit);

}  // namespace tumble::golden
