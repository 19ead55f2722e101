#pragma once

#include "golden/judge/case_json.h"
#include "tumble/golden/suite_result.h"

namespace tumble::golden {

/// report.json (docs/commands.md).
Json report_json(const SuiteResult& result);

}  // namespace tumble::golden
