#include "golden/canaries/suite_canaries.h"

#include <cstdlib>
#include <set>

#include "golden/run/longest_first.h"
#include "replay/measure/mirrored_pair.h"
#include "tumble/process/job_pool.h"

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
    const Selection selection = {.names = {}, .category = "", .shard = k, .shards = 3};
    const Result<std::vector<CaseFolder>> all = select_cases(five_cases(), selection);
    if (!all.ok()) return false;
    for (const CaseFolder& folder : shard_of(*all, selection)) names.insert(folder.name);
  }
  return names.size() == kCases && std::set<std::string>(names.begin(), names.end()).size() == kCases;
}

bool unreadable_cases_are_run() { return longest_first(five_cases().cases).size() == kCases; }

/// A suite in which everything passed.
SuiteResult passing() {
  SuiteResult suite;
  CaseResult& one = suite.cases.emplace_back();
  one.require = {VerdictKind::kExact};
  one.verdict(VerdictKind::kExact).outcome = Outcome::kPass;
  suite.canaries = {{"seen", true, "", "suite"}, {"seen", true, "", "suite"}};
  return suite;
}

/// True if a suite with this one fault fails.
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
  process::run_jobs(
      1, [](std::size_t) -> std::string { std::_Exit(0); },
      [&](std::size_t, const process::JobResult& child) { seen = !child.failure.empty(); }, {});
  return seen;
}

/// All transformed scenes of the suite are exact: only this canary shows that an inexact one would be seen.
bool inexact_images_are_seen() {
  replay::BodyStates body;
  body.id = {1};
  body.position = {{0}, {0}, {0}};
  body.orientation = {{1}, {0}, {0}, {0}};
  body.velocity = body.spin = body.position;
  body.frozen = {0};
  replay::BodyStates moved = body;
  moved.position.z = {0.5};
  replay::PairMeter meter({}, {});
  meter.add(1, body, body);
  if (meter.report().error != 0) return false;
  meter.add(2, body, moved);
  return meter.report().error == 0.5 && meter.report().differing == 1;
}

auto seen(bool (*is_seen)()) {
  return [is_seen]() -> CanaryResult {
    const bool caught = is_seen();
    return {"", caught, caught ? "seen" : "not seen", "suite"};
  };
}

}  // namespace

void run_suite_canaries(CanaryRoll& roll) {
  roll.ask("all shards together must be the suite", seen(shards_make_a_whole));
  roll.ask("a case that cannot be read is left out", seen(unreadable_cases_are_run));
  roll.ask("a canary, a case or a suite fails", seen(failures_add_up));
  roll.ask("a mirror image is half a metre off", seen(inexact_images_are_seen));
  roll.ask("a case ends before it is done", seen(early_end_is_seen));
}

}  // namespace tumble::golden
