#include "tests/support/golden_shards.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "golden/bundle/bundle.h"
#include "golden/bundle/file_hashes.h"
#include "golden/bundle/merge.h"
#include "golden/report/report_place.h"
#include "golden/suite/text_files.h"
#include "tumble/golden/report.h"

namespace tumble::golden {

namespace fs = std::filesystem;

void MadeShards::write(const fs::path& path, const std::string& text) {
  ASSERT_TRUE(write_file(path, std::string_view(text)).ok()) << path;
}

std::string MadeShards::read(const fs::path& path) {
  const Result<std::string> text = read_text(path);
  EXPECT_TRUE(text.ok()) << path;
  return text.ok() ? *text : "";
}

SuiteResult check_shard(const TemporarySuite& suite, std::size_t shard, std::size_t shards, const fs::path& report) {
  CheckOptions options;
  options.suite = suite.root();
  options.selection.shard = shard;
  options.selection.shards = shards;
  options.report = report;
  options.pool.jobs = 2;
  EXPECT_TRUE(prepare_report(options.suite, report, "").ok());
  const Result<SuiteResult> result = check_suite(options);
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().message);
  if (!result.ok()) return {};
  EXPECT_TRUE(write_reports(*result, report, "").ok());
  EXPECT_TRUE(write_bundle(*result, report).ok());
  return *result;
}

void MadeShards::make_shard(std::size_t k) {
  const fs::path report = shard(k);
  SuiteResult result;
  result.suite = "made";
  result.shard = k;
  result.shards = kShards;
  result.run = this_program();
  result.facts = {
      std::string(32, 'a'), std::string(32, 'b'), "", "", {{"require", ""}, {"timeout", "600"}}, {}, {}, {}};
  for (const char* name : {"one", "two", "three", "four", "five"}) {
    result.facts.canaries.emplace_back(name);
    if (shard_of_name(name, kShards) == k) result.canaries.push_back({name, true, "seen", "suite"});
  }
  std::vector<std::string> names;
  for (std::size_t i = 0; i < kCases; ++i) names.push_back("case_" + std::to_string(i));
  std::ranges::sort(names);
  result.selected = names.size();
  result.facts.selected_hash = names_hash(names);
  for (const std::string& name : names) {
    if (shard_of_name(name, kShards) != k) continue;
    result.facts.expected.push_back(name);
    CaseResult& one = result.cases.emplace_back();
    one.name = name;
    one.require = {VerdictKind::kExact};
    one.verdict(VerdictKind::kExact).outcome = name == "case_7" ? Outcome::kFail : Outcome::kPass;
    if (one.passed()) continue;
    one.artifacts = {"cases/" + name + "/actual.tumble"};
    write(report / one.artifacts.front(), "a session");
  }
  EXPECT_TRUE(write_reports(result, report, "").ok());
  EXPECT_TRUE(write_bundle(result, report).ok());
}

MadeShards::MadeShards() {
  std::string pattern = testing::TempDir() + "tumble-merge-XXXXXX";
  if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder " + pattern);
  root_ = pattern;
  for (std::size_t k = 1; k <= kShards; ++k) {
    folders_.push_back(shard(k));
    make_shard(k);
  }
}

MadeShards::~MadeShards() {
  std::error_code ignored;
  fs::remove_all(root_, ignored);
}

Result<SuiteResult> MadeShards::merge() {
  if (Status ok = prepare_merged_report(folders_, out(), ""); !ok.ok()) return ok.error();
  return merge_bundles({folders_, out(), {}, {}});
}

void MadeShards::edit(std::size_t k, const std::function<void(Manifest& manifest)>& change) {
  Result<Manifest> manifest = read_manifest(shard(k));
  ASSERT_TRUE(manifest.ok()) << manifest.error().message;
  change(*manifest);
  write(shard(k) / kBundleFile, manifest_text(*manifest));
}

void MadeShards::edit_report(std::size_t k, const std::function<void(Json& report)>& change) {
  Json report = Json::parse(read(shard(k) / kReportFile));
  change(report);
  write(shard(k) / kReportFile, report.dump());
  const Result<FileHash> hash = hash_file(shard(k) / kReportFile);
  ASSERT_TRUE(hash.ok());
  edit(k, [&](Manifest& m) { m.files.front() = {kReportFile, hash->bytes, hash->hash}; });
}

void MadeShards::expect_error(ErrorKind kind, const std::vector<std::string>& parts) {
  write(out() / kBundleFile, "{}\n");  // of an earlier merge
  const Result<SuiteResult> result = merge();
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().kind, kind) << result.error().message;
  for (const std::string& part : parts) {
    EXPECT_NE(result.error().message.find(part), std::string::npos) << part << "\nis not in\n"
                                                                    << result.error().message;
  }
  EXPECT_FALSE(fs::exists(out() / kBundleFile));
}

}  // namespace tumble::golden
