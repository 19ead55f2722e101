#pragma once

#include <string>

#include "golden/case_result.h"

namespace tumble::golden {

/// The pictures of a case for index.html: how many, and for each that is not as blessed what differs, with expected,
/// actual and difference beside each other. The images lie in the report's folder, where run_case() leaves them.
std::string picture_section(const CaseResult& result);

}  // namespace tumble::golden
