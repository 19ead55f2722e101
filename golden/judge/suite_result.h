#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tumble/golden/case_result.h"
#include "tumble/golden/change.h"
#include "tumble/golden/run_facts.h"

/// The results of one check: its cases and its canaries.
namespace tumble::golden {

/// A comparison of known outcome, most of them of a fault that must be found, and whether it came.
struct CanaryResult {
  std::string name;  ///< the fault made on purpose, or the answer: "the last state differs"
  bool caught = false;
  std::string message;  ///< of the judge
  std::string about =
      "suite";        ///< the part that is broken if it is not caught: "suite", or "format" for log and golden
  bool asked = true;  ///< false: this machine has not what it takes, as the message says; nothing was judged
  [[nodiscard]] bool missed() const { return asked && !caught; }
};

struct SuiteResult {
  std::string suite;  ///< its folder
  std::size_t shard = 1;
  std::size_t shards = 1;
  std::size_t selected = 0;            ///< cases of all shards together
  Provenance run;                      ///< of this check
  RunFacts facts;                      ///< for its bundle
  double seconds = 0;                  ///< of wall time
  std::vector<CaseResult> cases;       ///< by name
  std::vector<std::string> problems;   ///< of the suite itself; each fails the check
  std::vector<CanaryResult> canaries;  ///< those that fell to this shard

  /// How many were caught, "168 of 168 canaries caught", and how many fell to other shards or could not be asked.
  [[nodiscard]] std::string canaries_text() const;

  /// None was missed. Of a check that is no shard also: there are some.
  [[nodiscard]] bool canaries_caught() const;
  /// A shard that no case fell to: nothing failed, and nothing was judged either.
  [[nodiscard]] bool is_empty_shard() const { return cases.empty() && problems.empty() && shards > 1; }
  /// Every case passed, the suite has no problem and every canary was caught. True for an empty shard.
  [[nodiscard]] bool passed() const;
  [[nodiscard]] std::size_t failed_cases() const;
  /// Cases that require this verdict and failed it. A case may fail verdicts that it does not require.
  [[nodiscard]] std::size_t failed(VerdictKind kind) const;
  /// Cases with this change, passed or not.
  [[nodiscard]] std::size_t with(Change change) const;
};

/// "3 of 45 cases failed; verdicts failed: exact 2" (of these cases), "45 cases passed: 43 unchanged, 2 moved within
/// bounds" or "nothing was judged: shard 5 of 5 has no case".
std::string headline(const SuiteResult& result);

}  // namespace tumble::golden
