#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "golden/canaries/canaries.h"
#include "golden/judge/case_result.h"
#include "golden/run/process_pool.h"
#include "golden/suite/suite.h"
#include "src/base/result.h"

namespace tumble::golden {

struct CheckOptions {
  std::filesystem::path suite;
  Selection selection;
  std::optional<std::vector<VerdictKind>> require;  ///< instead of what each case says
  std::filesystem::path report;                     ///< where failed cases leave their files; empty: nowhere
  PoolOptions pool;
  Judge canary_judge = judge;  ///< what the canaries are put before: the judge of the cases, except in a test
  /// Called as each case ends; may be empty.
  std::function<void(const CaseResult& result, std::size_t done, std::size_t total)> progress;
};

struct SuiteResult {
  std::string suite;  ///< its folder
  std::size_t shard = 1;
  std::size_t shards = 1;
  double seconds = 0;                 ///< of wall time
  std::vector<CaseResult> cases;      ///< by name
  std::vector<std::string> problems;  ///< of the suite itself; each fails the check
  std::vector<CanaryResult> canaries;

  [[nodiscard]] bool canaries_caught() const;
  /// Every case passed, the suite has no problem and every canary was caught.
  [[nodiscard]] bool passed() const;
  [[nodiscard]] std::size_t failed_cases() const;
  /// Cases whose verdict failed, required or not.
  [[nodiscard]] std::size_t failed(VerdictKind kind) const;
};

/// Runs the canaries, then the cases, each in a process of its own, the longest first. Errors: open_suite's and
/// select_cases'; kCannotFinish if cancelled.
Result<SuiteResult> check_suite(const CheckOptions& options);

/// Cases with the most body-steps first, so that no long one is left over at the end.
std::vector<CaseFolder> longest_first(std::vector<CaseFolder> folders);

}  // namespace tumble::golden
