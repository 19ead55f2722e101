#pragma once

#include <string>

#include "golden/report/files.h"
#include "golden/report/html_text.h"
#include "tumble/golden/case_result.h"

namespace tumble::golden {

/// One case, to be opened and closed: problems, verdicts, magnitude, pictures, plots, metrics, commands, files. suite:
/// the folder, as given to the check.
Html case_section(const CaseResult& result, const std::string& suite, ReportFiles& files);

}  // namespace tumble::golden
