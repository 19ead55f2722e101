#include "golden/judge/suite_result.h"

#include <algorithm>

namespace tumble::golden {

bool SuiteResult::canaries_caught() const {
  return !canaries.empty() && std::ranges::all_of(canaries, &CanaryResult::caught);
}

bool SuiteResult::passed() const { return problems.empty() && canaries_caught() && failed_cases() == 0; }

std::size_t SuiteResult::failed_cases() const {
  return static_cast<std::size_t>(std::ranges::count_if(cases, [](const CaseResult& c) { return !c.passed(); }));
}

std::size_t SuiteResult::failed(VerdictKind kind) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(cases, [&](const CaseResult& c) { return c.verdict(kind).outcome == Outcome::kFail; }));
}

std::string headline(const SuiteResult& result) {
  const std::string total = std::to_string(result.cases.size()) + (result.cases.size() == 1 ? " case" : " cases");
  if (!result.canaries_caught()) return "a canary was not caught: no verdict of this check can be trusted";
  if (result.passed()) return total + " passed";
  std::string text = std::to_string(result.failed_cases()) + " of " + total + " failed";
  std::string verdicts;
  for (std::size_t k = 0; k < kVerdictNames.size(); ++k) {
    const std::size_t failed = result.failed(static_cast<VerdictKind>(k));
    if (failed == 0) continue;
    verdicts += (verdicts.empty() ? "; verdicts failed: " : ", ") + std::string(kVerdictNames[k]) + ' ' +
                std::to_string(failed);
  }
  text += verdicts;
  if (!result.problems.empty()) text += "; " + result.problems.front();
  return text;
}

}  // namespace tumble::golden
