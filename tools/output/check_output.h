#pragma once

#include <string>

#include "golden/bless/bless.h"
#include "golden/judge/suite_result.h"

namespace tumble::tools {

/// A line for a case that passed, all that a person needs for one that failed.
void print_case(const golden::CaseResult& result);

/// The end of `check`: what is wrong with suite and canaries, the sum of it.
void print_sum(const golden::SuiteResult& result, const std::string& report);

/// `bless` for people. dry_run: nothing was written.
void print_blessings(const golden::BlessReport& report, bool dry_run);

golden::Json blessings_json(const golden::BlessReport& report, bool dry_run);

}  // namespace tumble::tools
