#pragma once

#include <string>

#include "golden/judge/suite_result.h"

namespace tumble::golden {

/// junit.xml, for CI.
std::string report_junit(const SuiteResult& result);

}  // namespace tumble::golden
