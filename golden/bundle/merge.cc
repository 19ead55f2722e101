#include "golden/bundle/merge.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include "golden/bundle/bundle_set.h"
#include "golden/bundle/read_results.h"

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;

/// The machines and the times of all shards; the rest is the same in all.
Provenance run_of(const std::vector<Bundle>& bundles) {
  Provenance run = bundles.front().manifest.run;
  std::set<std::string> machines;
  for (const Bundle& one : bundles) {
    machines.insert(one.manifest.run.machine);
    run.date = std::min(run.date, one.manifest.run.date);
    run.seconds = std::max(run.seconds, one.manifest.run.seconds);
  }
  run.machine.clear();
  for (const std::string& machine : machines) run.machine += (run.machine.empty() ? "" : "; ") + machine;
  return run;
}

void add_problems(const std::vector<std::string>& problems, SuiteResult& result) {
  for (const std::string& one : problems) {
    if (std::ranges::find(result.problems, one) == result.problems.end()) result.problems.push_back(one);
  }
}

/// Puts the canaries into the order of the list that all shards have; each is there once, as open_bundles saw.
void sort_canaries(SuiteResult& result) {
  std::map<std::string, std::size_t> place;
  for (const std::string& name : result.facts.canaries) place.emplace(name, place.size());
  std::ranges::sort(result.canaries, {}, [&](const CanaryResult& one) { return place.at(one.name); });
}

Status copy_artifacts(const Bundle& bundle, const fs::path& report) {
  for (const BundleFile& file : bundle.manifest.files) {
    if (file.path == kReportFile) continue;
    const fs::path to = report / file.path;
    std::error_code error;
    fs::create_directories(to.parent_path(), error);
    fs::copy_file(bundle.folder / file.path, to, fs::copy_options::overwrite_existing, error);
    if (error) return cannot_finish(to.string() + ": cannot be written: " + error.message());
  }
  return {};
}

}  // namespace

Result<SuiteResult> merge_bundles(const MergeOptions& options) {
  const Result<std::vector<Bundle>> bundles = open_bundles(options.bundles);
  if (!bundles.ok()) return bundles.error();
  const Manifest& first = bundles->front().manifest;
  SuiteResult result;
  result.suite = first.suite;
  result.selected = first.selected;
  result.run = run_of(*bundles);
  result.seconds = result.run.seconds;
  result.facts = first.facts;
  result.facts.expected.clear();
  result.facts.merged.clear();
  result.cases.reserve(first.selected);
  for (const Bundle& one : *bundles) {
    const Manifest& m = one.manifest;
    const Result<ShardReport> report =
        read_results(one, [&](CaseResult found) { result.cases.push_back(std::move(found)); });
    if (!report.ok()) return report.error();
    add_problems(report->problems, result);
    result.canaries.insert(result.canaries.end(), report->canaries.begin(), report->canaries.end());
    result.facts.merged.push_back(
        {m.shard, m.judged.size(), m.canaries.size(), m.run.seconds, m.run.machine, m.run.date});
    if (options.progress) options.progress(m.shard, bundles->size());
  }
  if (Status ok = options.make_ready ? options.make_ready() : Status(); !ok.ok()) return ok.error();
  for (const Bundle& one : *bundles) {
    if (Status ok = copy_artifacts(one, options.report); !ok.ok()) return ok.error();
  }
  std::ranges::sort(result.cases, {}, &CaseResult::name);
  sort_canaries(result);
  for (const CaseResult& one : result.cases) result.facts.expected.push_back(one.name);
  return result;
}

}  // namespace tumble::golden
