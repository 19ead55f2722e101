#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "golden/judge/case_result.h"

/// The results of one check: its cases and its canaries.
namespace tumble::golden {

/// A comparison that must fail, and whether it did.
struct CanaryResult {
  std::string name;  ///< the fault made on purpose: "the last state differs"
  bool caught = false;
  std::string message;  ///< of the judge
  std::string about =
      "suite";  ///< the part that is broken if it is not caught: "suite", or "format" for log and golden
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

/// "3 of 45 cases failed: exact 2, behaviour 1" or "45 cases passed".
std::string headline(const SuiteResult& result);

}  // namespace tumble::golden
