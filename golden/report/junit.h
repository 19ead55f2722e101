#pragma once

#include <string>

#include "tumble/golden/suite_result.h"

namespace tumble::golden {

/// junit.xml, for CI.
std::string report_junit(const SuiteResult& result);

}  // namespace tumble::golden
