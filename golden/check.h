#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tumble/golden/judge.h"
#include "tumble/golden/suite.h"
#include "tumble/golden/suite_result.h"
#include "tumble/process/job_pool.h"
#include "tumble/sim/result.h"

namespace tumble::golden {

struct CheckOptions {
  std::filesystem::path suite;
  Selection selection;
  std::optional<std::vector<VerdictKind>> require;  ///< overrides each case's own list
  bool heavy = false;                               ///< every session is gone on with from each of its steps too
  std::filesystem::path report;                     ///< folder for the files of failed cases; empty: none
  std::filesystem::path junit;                      ///< JUnit's report; empty: junit.xml in that folder
  process::PoolOptions pool;
  Judge canary_judge = judge;  ///< judges the canaries: the judge of the cases, except in a test
  /// Called as each case ends; may be empty.
  std::function<void(const CaseResult& result, std::size_t done, std::size_t total)> progress;
};

/// Runs the canaries, then the cases, each in a process of its own, the longest first. Errors: open_suite's and
/// select_cases'; kBadInput for a report among the cases; kCannotFinish if cancelled.
Result<SuiteResult> check_suite(const CheckOptions& options);

}  // namespace tumble::golden
