#include "golden/bundle/bundle.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "golden/bundle/file_hashes.h"
#include "golden/bundle/manifest.h"
#include "golden/suite/text_files.h"
#include "src/base/text.h"

namespace tumble::golden {
namespace {

std::vector<std::string> names_of(const std::vector<CaseFolder>& folders) {
  std::vector<std::string> names;
  names.reserve(folders.size());
  for (const CaseFolder& folder : folders) names.push_back(folder.name);
  return names;
}

/// Of the engine of the suite's tumble.toml, where one of these cases runs it.
std::string hash_of_engine(const Suite& suite, const std::vector<CaseFolder>& cases) {
  const bool runs = std::ranges::any_of(cases, [](const CaseFolder& one) { return engine_case(one).has_value(); });
  if (!runs) return "";
  const Result<std::optional<EngineProject>> project = find_project(suite.root);
  return project.ok() && *project ? engine_hash(**project) : "not known";
}

}  // namespace

RunFacts facts_of_run(const Suite& suite, const std::vector<CaseFolder>& all, const std::vector<CaseFolder>& mine,
                      const std::optional<std::vector<VerdictKind>>& require, double timeout_s) {
  RunFacts facts;
  facts.program_hash = program_hash();
  facts.suite_hash = suite_hash(suite);
  facts.engine_hash = hash_of_engine(suite, mine);
  facts.selected_hash = names_hash(names_of(all));
  facts.expected = names_of(mine);
  std::vector<std::string> verdicts;
  if (require) {
    for (const VerdictKind kind : *require) verdicts.emplace_back(kVerdictNames[static_cast<std::size_t>(kind)]);
  }
  facts.options = {{"require", joined(verdicts, " ")}, {"timeout", exact(timeout_s)}};
  return facts;
}

Status write_bundle(const SuiteResult& result, const std::filesystem::path& folder) {
  Manifest manifest{.suite = result.suite,
                    .shard = result.shard,
                    .shards = result.shards,
                    .assignment = kAssignment,
                    .selected = result.selected,
                    .run = result.run,
                    .facts = result.facts,
                    .judged = {},
                    .canaries = {},
                    .files = {}};
  std::vector<std::string> paths = {kReportFile};
  for (const CaseResult& one : result.cases) {
    manifest.judged.push_back(one.name);
    paths.insert(paths.end(), one.artifacts.begin(), one.artifacts.end());
  }
  for (const CanaryResult& one : result.canaries) manifest.canaries.push_back(one.name);
  for (const std::string& path : paths) {
    const Result<FileHash> found = hash_file(folder / path);
    if (!found.ok()) return cannot_finish(found.error().message);
    manifest.files.push_back({path, found->bytes, found->hash});
  }
  return write_file(folder / kBundleFile, std::string_view(manifest_text(manifest)));
}

}  // namespace tumble::golden
