#include "tumble/golden/check.h"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <utility>

#include "golden/bundle/bundle.h"
#include "golden/canaries/canaries.h"
#include "golden/judge/case_json.h"
#include "golden/report/report_place.h"
#include "golden/run/external_engine.h"
#include "golden/run/longest_first.h"
#include "golden/run/run_case.h"
#include "golden/suite/parse_rules.h"
#include "golden/suite/temporary_folder.h"

namespace tumble::golden {
namespace {

CaseResult result_of(const CaseFolder& folder, const CheckOptions& options, const process::JobResult& child) {
  std::string failure = "its process " + child.failure;
  if (child.failure.empty()) {
    Result<CaseResult> result = case_from_json(child.output);
    if (result.ok()) return *std::move(result);
    failure = result.error().message;
  }
  // The case is not run here: a crash that ended the child would end this process too.
  CaseResult result;
  result.name = folder.name;
  result.problems.push_back(failure);
  result.bless_refused = failure;
  result.require = options.require.value_or(CaseRules().require);
  const Result<CaseRules> rules = read_rules(folder.file(kRulesFile));
  if (rules.ok()) result.reproduce = reproduce_command(folder, options.suite, *rules);
  return result;
}

/// A canary that cannot write its files would tell that the build cannot be trusted.
Status has_room_for_canaries() {
  // Where files may have 64 KiB at most a canary goes missing, with 128 KiB none does.
  constexpr std::size_t kBytes = std::size_t{256} << 10;
  constexpr std::size_t kFiles = 16;
  return check_temporary_place(kBytes, kFiles);
}

}  // namespace

Result<SuiteResult> check_suite(const CheckOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  const Result<Suite> suite = open_suite(options.suite);
  if (!suite.ok()) return suite.error();
  const Result<std::vector<CaseFolder>> all = select_cases(*suite, options.selection);
  if (!all.ok()) return all.error();
  std::vector<CaseFolder> selected = shard_of(*all, options.selection);
  SuiteResult result;
  result.selected = all->size();
  result.suite = options.suite.string();
  result.run = this_program();
  result.shard = options.selection.shard;
  result.shards = options.selection.shards;
  result.problems = suite->problems;
  if (selected.empty() && result.shards == 1) result.problems.emplace_back("no case was run");
  const std::vector<CaseFolder> mine = selected;
  const std::vector<CaseFolder> folders = longest_first(std::move(selected));
  if (!options.report.empty()) {
    if (Status ok = prepare_report(options.suite, options.report, options.junit); !ok.ok()) return ok.error();
  }
  if (Status ok = build_engine_of(folders, options.suite, options.pool.cancel); !ok.ok()) return ok.error();
  if (Status ok = has_room_for_canaries(); !ok.ok()) return ok.error();
  const CanaryRoll canaries =
      run_canaries(options.canary_judge, result.shard, result.shards);  // bad input is said first
  result.canaries = canaries.results();
  // A disk that became full meanwhile, and no build, may be why.
  if (Status ok = result.canaries_caught() ? Status() : has_room_for_canaries(); !ok.ok()) return ok.error();
  // Asked here too: no case may be the shard's, or all may end before the signal is seen.
  const auto interrupted = [&] { return options.pool.cancel && options.pool.cancel(); };
  if (interrupted()) return cannot_finish("interrupted before the first case");
  result.facts = facts_of_run(*suite, *all, mine, options.require, options.pool.timeout_s);
  result.facts.canaries = canaries.names();
  if (options.heavy) result.facts.options.emplace_back("heavy", kGiven);
  const TemporaryFolder scratch("tumble-check");  // a case that takes too long cannot remove its own files
  const RunOptions run = {.suite = options.suite,
                          .require = options.require,
                          .report = options.report,
                          .heavy = options.heavy,
                          .scratch = scratch.path()};
  const bool finished = process::run_jobs(
      folders.size(),
      [&](std::size_t i) {
        return to_json(run_case(folders[i], run).result).dump(-1, ' ', false, Json::error_handler_t::replace);
      },
      [&](std::size_t i, const process::JobResult& child) {
        result.cases.push_back(result_of(folders[i], options, child));
        result.cases.back().seconds = child.seconds;
        if (options.progress) options.progress(result.cases.back(), result.cases.size(), folders.size());
      },
      options.pool);
  if (!finished || interrupted())
    return cannot_finish("interrupted after " + std::to_string(result.cases.size()) + " cases");
  if (result.cases.size() != folders.size()) return cannot_finish("a case was lost: fewer results than cases");
  std::ranges::sort(result.cases, {}, &CaseResult::name);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  result.run.seconds = result.seconds;
  return result;
}

}  // namespace tumble::golden
