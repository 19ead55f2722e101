#pragma once

#include <string>

#include "golden/judge/case_result.h"
#include "golden/report/files.h"

namespace tumble::golden {

/// The pictures of a case for index.html: their number, and for each that is not as blessed its difference, with
/// expected, actual and difference beside each other. The page's script turns them into one picture with a slider.
std::string picture_section(const CaseResult& result, ReportFiles& files);

}  // namespace tumble::golden
