#pragma once

#include <string>

#include "golden/judge/case_json.h"
#include "tumble/golden/bless.h"
#include "tumble/golden/suite_result.h"

namespace tumble::tools {

/// Prints a line for a case that passed, all details for one that failed.
void print_case(const golden::CaseResult& result);

/// Prints the end of `check`: problems of suite and canaries, the totals, the folders of the suite and of the report.
void print_sum(const golden::SuiteResult& result, const std::string& suite, const std::string& report);

/// Prints the result of `bless`. dry_run: nothing was written.
void print_blessings(const golden::BlessReport& report, bool dry_run);

golden::Json blessings_json(const golden::BlessReport& report, bool dry_run);

}  // namespace tumble::tools
