#pragma once

#include <string>

#include "golden/judge/case_result.h"
#include "golden/report/files.h"

namespace tumble::golden {

/// The pictures of a case for index.html: how many, and for each that is not as blessed what differs, with expected,
/// actual and difference beside each other, which the page's script makes one picture with a slider and a blink.
std::string picture_section(const CaseResult& result, ReportFiles& files);

}  // namespace tumble::golden
