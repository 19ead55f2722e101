#include "golden/suite_canaries.h"

#include <cstdlib>
#include <set>

#include "golden/check.h"
#include "golden/process_pool.h"

namespace tumble::golden {
namespace {

constexpr std::size_t kCases = 5;

Suite five_cases() {
  Suite suite;
  for (std::size_t i = 0; i < kCases; ++i) suite.cases.push_back({"case" + std::to_string(i), "no such folder"});
  return suite;
}

bool shards_make_a_whole() {
  std::multiset<std::string> names;
  for (std::size_t k = 1; k <= 3; ++k) {
    const auto shard = select_cases(five_cases(), {.names = {}, .category = "", .shard = k, .shards = 3});
    if (!shard.ok()) return false;
    for (const CaseFolder& folder : *shard) names.insert(folder.name);
  }
  return names.size() == kCases && std::set<std::string>(names.begin(), names.end()).size() == kCases;
}

bool unreadable_cases_are_run() { return longest_first(five_cases().cases).size() == kCases; }

/// A suite of which everything passed.
SuiteResult passing() {
  SuiteResult suite;
  CaseResult& one = suite.cases.emplace_back();
  one.require = {VerdictKind::kExact};
  one.verdict(VerdictKind::kExact).outcome = Outcome::kPass;
  suite.canaries = {{"seen", true, "", "suite"}, {"seen", true, "", "suite"}};
  return suite;
}

/// A suite in which this one thing is wrong must fail.
bool fails(void (*spoil)(SuiteResult& suite)) {
  SuiteResult suite = passing();
  if (!suite.passed()) return false;
  spoil(suite);
  return !suite.passed();
}

bool failures_add_up() {
  return fails([](SuiteResult& suite) { suite.canaries.back().caught = false; }) &&
         fails([](SuiteResult& suite) { suite.canaries.clear(); }) &&
         fails([](SuiteResult& suite) { suite.problems.emplace_back("a problem"); }) &&
         fails([](SuiteResult& suite) { suite.cases.front().problems.emplace_back("a problem"); }) &&
         fails([](SuiteResult& suite) { suite.cases.front().require.clear(); }) && fails([](SuiteResult& suite) {
           suite.cases.emplace_back(suite.cases.front()).verdict(VerdictKind::kExact).outcome = Outcome::kFail;
         }) &&
         fails([](SuiteResult& suite) { suite.cases.front().verdict(VerdictKind::kExact).outcome = Outcome::kNone; });
}

bool early_end_is_seen() {
  bool seen = false;
  run_jobs(
      1, [](std::size_t) -> std::string { std::_Exit(0); },
      [&](std::size_t, const ChildResult& child) { seen = !child.failure.empty(); }, {});
  return seen;
}

}  // namespace

std::vector<CanaryResult> run_suite_canaries() {
  const auto canary = [](const char* name, bool caught) {
    return CanaryResult{name, caught, caught ? "seen" : "not seen", "suite"};
  };
  return {canary("all shards together must be the suite", shards_make_a_whole()),
          canary("a case that cannot be read is left out", unreadable_cases_are_run()),
          canary("a canary, a case or a suite fails", failures_add_up()),
          canary("a case ends before it is done", early_end_is_seen())};
}

}  // namespace tumble::golden
