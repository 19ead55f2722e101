#include "tumble/golden/suite_result.h"

#include <algorithm>

#include "src/base/text.h"

namespace tumble::golden {
namespace {

/// "43 unchanged, 2 moved within bounds". A case may pass with more than that where it requires one verdict alone.
std::string changes_text(const SuiteResult& result) {
  std::string text;
  for (const Change change : {Change::kNone, Change::kWithinBounds, Change::kOutOfBounds, Change::kNotJudged}) {
    const std::size_t n = result.with(change);
    if (n > 0) text += (text.empty() ? "" : ", ") + std::to_string(n) + ' ' + to_string(change);
  }
  return text;
}

}  // namespace

bool SuiteResult::canaries_caught() const {
  return (shards > 1 || !canaries.empty()) && std::ranges::none_of(canaries, &CanaryResult::missed);
}

std::string SuiteResult::canaries_text() const {
  const auto asked = static_cast<std::size_t>(std::ranges::count_if(canaries, &CanaryResult::asked));
  const auto caught = static_cast<std::size_t>(std::ranges::count_if(canaries, &CanaryResult::caught));
  std::string text = std::to_string(caught) + " of " + count_text(asked, "canary") + " caught";
  if (canaries.empty() && shards > 1) text = "no canary";
  if (const std::size_t left = canaries.size() - asked; left > 0) text += ", " + std::to_string(left) + " not asked";
  if (facts.canaries.size() > canaries.size()) {
    text += ", " + std::to_string(facts.canaries.size() - canaries.size()) + " fell to other shards";
  }
  return text;
}

bool SuiteResult::passed() const { return problems.empty() && canaries_caught() && failed_cases() == 0; }

std::size_t SuiteResult::failed_cases() const {
  return static_cast<std::size_t>(std::ranges::count_if(cases, [](const CaseResult& c) { return !c.passed(); }));
}

std::size_t SuiteResult::failed(VerdictKind kind) const {
  return static_cast<std::size_t>(std::ranges::count_if(cases, [&](const CaseResult& c) {
    return std::ranges::find(c.require, kind) != c.require.end() && c.verdict(kind).outcome == Outcome::kFail;
  }));
}

std::size_t SuiteResult::with(Change change) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(cases, [&](const CaseResult& c) { return change_of(c) == change; }));
}

std::string headline(const SuiteResult& result) {
  const std::string total = std::to_string(result.cases.size()) + (result.cases.size() == 1 ? " case" : " cases");
  if (!result.canaries_caught()) return "a canary was not caught: no verdict of this check can be trusted";
  if (result.is_empty_shard()) {
    return "nothing was judged: shard " + std::to_string(result.shard) + " of " + std::to_string(result.shards) +
           " has no case, of " + std::to_string(result.selected) + " in all";
  }
  if (result.passed()) return total + " passed: " + changes_text(result);
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
