#pragma once

#include "golden/report/files.h"
#include "golden/report/html_text.h"
#include "tumble/golden/case_result.h"

namespace tumble::golden {

/// The pictures of a case: verdicts in words, and for each that moved expected, actual and difference. Empty if the
/// case names none.
Html picture_section(const CaseResult& result, ReportFiles& files);

}  // namespace tumble::golden
