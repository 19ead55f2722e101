// A suite checked in shards and merged is the suite checked at once; a shard that is wrong is named.
#include "golden/bundle/merge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "golden/bundle/bundle.h"
#include "golden/bundle/file_hashes.h"
#include "golden/bundle/manifest.h"
#include "golden/report/junit.h"
#include "golden/report/report_json.h"
#include "golden/report/report_place.h"
#include "tests/support/golden_shards.h"
#include "tests/support/golden_suite.h"
#include "tumble/golden/report.h"

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;

class Merge : public MadeShards {};

/// Without durations, dates and hosts.
Json comparable(const SuiteResult& result) {
  Json json = report_json(result);
  for (const char* key : {"seconds", "run", "folder"}) json.erase(key);
  for (Json& one : json["cases"]) one.erase("seconds");
  return json;
}

std::string junit_without_times(SuiteResult result) {
  result.run = {};
  result.seconds = 0;
  for (CaseResult& one : result.cases) one.seconds = 0;
  return report_junit(result);
}

TEST_F(Merge, IsTheCheckOfTheWholeSuite) {
  const TemporarySuite suite;
  for (std::size_t k = 0; k < kCases; ++k) {
    std::string scene = kFallingBoxes;
    scene.replace(scene.find("0.7"), 3, "0." + std::to_string(700 + k));
    scene.replace(scene.find("steps = 30"), 10, "steps = 2");
    suite.add("case_" + std::to_string(k), scene);
  }
  suite.bless();
  for (const char* name : {"case_3", "case_44", "case_145"}) {
    suite.edit(name, kRulesFile, "max = 100.0", "max = -1.0");
    suite.edit(name, kSceneFile, "spin = [0.5", "spin = [0.25");
  }
  suite.write(suite.root() / "cases" / "stray.txt", "belongs to no case");
  const SuiteResult whole = check_shard(suite, 1, 1, root_ / "whole");
  for (std::size_t k = 1; k <= kShards; ++k) check_shard(suite, k, kShards, shard(k));
  const Result<SuiteResult> merged = merge();
  ASSERT_TRUE(merged.ok()) << merged.error().message;
  EXPECT_EQ(merged->cases.size(), kCases);
  EXPECT_EQ(merged->failed_cases(), 3U);
  EXPECT_EQ(merged->problems.size(), 1U);
  EXPECT_EQ(comparable(*merged).dump(1), comparable(whole).dump(1));
  EXPECT_EQ(junit_without_times(*merged), junit_without_times(whole));
  EXPECT_EQ(headline(*merged), headline(whole));
  for (const CaseResult& one : whole.cases) {
    for (const std::string& file : one.artifacts) EXPECT_EQ(read(out() / file), read(root_ / "whole" / file)) << file;
  }
  EXPECT_EQ(merged->facts.merged.size(), kShards);
}

TEST_F(Merge, ItsReportCanBeMergedAgain) {
  const Result<SuiteResult> merged = merge();
  ASSERT_TRUE(merged.ok()) << merged.error().message;
  ASSERT_TRUE(write_reports(*merged, out(), "").ok());
  ASSERT_TRUE(write_bundle(*merged, out()).ok());
  const Result<Manifest> manifest = read_manifest(out());
  ASSERT_TRUE(manifest.ok()) << manifest.error().message;
  EXPECT_EQ(manifest->facts.merged.size(), kShards);
  const fs::path again = root_ / "again";
  const Result<SuiteResult> second = merge_bundles({{out()}, again, {}, {}});
  ASSERT_TRUE(second.ok()) << second.error().message;
  EXPECT_EQ(comparable(*second), comparable(*merged));
}

TEST_F(Merge, NamesEveryShardThatIsLostDoubledOrForeign) {
  fs::remove_all(shard(2));                                         // lost, its folder too
  folders_.erase(folders_.begin() + 2);                             // 3: not given
  fs::remove(shard(4) / kBundleFile);                               // did not end
  fs::copy(shard(5), root_ / "five", fs::copy_options::recursive);  // 5: twice
  folders_.push_back(root_ / "five");
  folders_.push_back(shard(6));  // 6: the same folder twice
  edit(7, [](Manifest& m) { m.run.commit = std::string(40, 'f'); });
  edit(8, [](Manifest& m) { m.facts.program_hash = std::string(32, '1'); });
  edit(9, [](Manifest& m) { m.facts.suite_hash = std::string(32, '2'); });
  edit(10, [](Manifest& m) { m.shards = 21; });
  edit(11, [](Manifest& m) { m.facts.options = {{"require", "exact"}, {"timeout", "600"}}; });
  edit(12, [](Manifest& m) { m.facts.selected_hash = std::string(32, '3'); });
  edit(13, [](Manifest& m) { m.assignment = "every N-th"; });
  write(shard(14) / kBundleFile, R"({"format": 3})");
  edit(15, [](Manifest& m) { m.facts.engine_hash = std::string(32, '4'); });
  edit(16, [](Manifest& m) { m.facts.engine_hash = std::string(32, '5'); });
  edit(17, [](Manifest& m) { m.facts.engine_hash = std::string(32, '5'); });
  expect_error(ErrorKind::kDamaged,
               {shard(2).string() + ": no such folder", "shard 3 of 20: is missing",
                shard(4).string() + ": holds no bundle.json",
                (root_ / "five").string() + ": shard 5 of 20: is there twice: " + shard(5).string(),
                shard(6).string() + ": shard 6 of 20: is there twice",
                shard(7).string() + ": shard 7 of 20: of another commit: found " + std::string(40, 'f'),
                "shard 8 of 20: of another program (its file's hash): found " + std::string(32, '1'),
                "shard 9 of 20: of another suite (its files' hash): found " + std::string(32, '2'),
                "shard 10 of 21: of another number of shards: found 21",
                "shard 11 of 20: of another set of options: found --require exact --timeout 600",
                "shard 15 of 20: of another engine (its files' hash): found " + std::string(32, '4'),
                "shard 12 of 20: of another selection of cases", "shard 13 of 20: of another rule",
                shard(14).string() + "/bundle.json: damaged", "shard 14 of 20: is missing"});
}

TEST_F(Merge, AShardThatRanNoEngineMergesWithOthers) {
  edit(3, [](Manifest& m) { m.facts.engine_hash = std::string(32, '4'); });
  const Result<SuiteResult> merged = merge();
  EXPECT_TRUE(merged.ok()) << merged.error().message;
}

// Of the words of its command, those that are files; the program also where PATH has it.
TEST_F(Merge, AnEngineIsKnownByItsFiles) {
  fs::create_directories(root_ / "bin");
  write(root_ / "bin/engine", "one");
  write(root_ / "rules.txt", "two");
  const auto hash = [&](const std::string& run) { return engine_hash(project_of_command(run, root_, false)); };
  const std::string first = hash("bin/engine --rules rules.txt {log}");
  EXPECT_EQ(first.size(), 32U);
  EXPECT_EQ(hash("bin/engine --rules rules.txt {log}"), first);
  EXPECT_NE(hash("bin/engine {log}"), first);
  write(root_ / "rules.txt", "three");
  const std::string second = hash("bin/engine --rules rules.txt {log}");
  EXPECT_NE(second, first);
  write(root_ / "bin/engine", "four");
  EXPECT_NE(hash("bin/engine --rules rules.txt {log}"), second);
  EXPECT_EQ(hash("bin/nothing {log}"), "not known");
  EXPECT_EQ(hash("sh {log}"), engine_hash(project_of_command("sh", "/", true)));
  EXPECT_EQ(hash("sh {log}").size(), 32U);
}

TEST_F(Merge, NamesEveryShardThatIsDamaged) {
  std::string text = read(shard(1) / kBundleFile);
  write(shard(1) / kBundleFile, text.substr(0, text.size() / 2));
  text = read(shard(2) / kBundleFile);
  text[text.find("\"judged\"") + 14] ^= 1;
  write(shard(2) / kBundleFile, text);
  text = read(shard(3) / kReportFile);
  text[text.size() / 2] ^= 1;
  write(shard(3) / kReportFile, text);
  write(shard(4) / kReportFile, "");
  fs::remove(shard(5) / kReportFile);
  fs::rename(shard(6) / kReportFile, shard(6) / "elsewhere");
  fs::create_symlink("elsewhere", shard(6) / kReportFile);
  edit(7, [](Manifest& m) { m.judged.pop_back(); });
  edit(8, [](Manifest& m) {
    m.facts.expected.emplace_back("zzz_17");
    m.judged = m.facts.expected;
  });
  edit(9, [](Manifest& m) { m.files.push_back({"../outside", 0, ""}); });
  edit(10, [](Manifest& m) { m.files.push_back({"index.html", 0, ""}); });
  edit(11, [](Manifest& m) { m.files.clear(); });
  edit(12, [](Manifest& m) { m.shard = 13; });
  edit(14, [](Manifest& m) { m.shard = 0; });
  edit(16, [](Manifest& m) { m.files.push_back({"cases/another/actual.tumble", 0, ""}); });
  fs::rename(shard(15), root_ / "moved");
  fs::create_directory(shard(15));
  fs::create_symlink(root_ / "moved" / kBundleFile, shard(15) / kBundleFile);
  expect_error(ErrorKind::kDamaged,
               {shard(1).string() + "/bundle.json: damaged: its end is missing",
                shard(2).string() + "/bundle.json: damaged: its text has the hash",
                shard(3).string() + ": shard 3 of 20: report.json: its content has changed",
                shard(4).string() + ": shard 4 of 20: report.json: found 0 bytes",
                shard(5).string() + ": shard 5 of 20: report.json: is missing",
                shard(6).string() + ": shard 6 of 20: report.json: is a link",
                shard(7).string() + ": shard 7 of 20: ", "are judged, wanted the same cases",
                shard(8).string() + ": shard 8 of 20: holds the case \"zzz_17\" of shard ",
                shard(9).string() + "/bundle.json: damaged: names the file \"../outside\"",
                shard(10).string() + ": shard 10 of 20: names the file \"index.html\"",
                shard(11).string() + ": shard 11 of 20: does not name its report.json",
                "shard 13 of 20: is there twice", shard(14).string() + "/bundle.json: damaged: found shard 0 of 20",
                shard(15).string() + "/bundle.json: is a link",
                shard(16).string() + ": shard 16 of 20: names the file \"cases/another/actual.tumble\""});
}

TEST_F(Merge, NamesASelectionOfOtherCases) {
  for (std::size_t k = 1; k <= kShards; ++k) {
    edit(k, [](Manifest& m) { m.facts.selected_hash = std::string(32, '4'); });
  }
  expect_error(ErrorKind::kDamaged, {"have 200 cases that are not the 200 selected ones"});
}

TEST_F(Merge, NamesTheArtifactThatIsDamaged) {
  const std::size_t owner = shard_of_name("case_7", kShards);
  write(shard(owner) / "cases/case_7/actual.tumble", "another session");
  expect_error(ErrorKind::kDamaged, {shard(owner).string(), "cases/case_7/actual.tumble: found 15 bytes, wanted 9"});
  fs::remove_all(shard(owner) / "cases");
  fs::create_directory(root_ / "elsewhere");
  fs::create_directory(root_ / "elsewhere/case_7");
  write(root_ / "elsewhere/case_7/actual.tumble", "a session");
  fs::create_directory_symlink(root_ / "elsewhere", shard(owner) / "cases");
  expect_error(ErrorKind::kDamaged, {shard(owner).string(), "cases/case_7/actual.tumble: is a link"});
}

TEST_F(Merge, NamesTheReportThatNoCheckWrote) {
  edit_report(3, [](Json& report) { report["cases"][0]["name"] = "another"; });
  expect_error(ErrorKind::kDamaged,
               {(shard(3) / kReportFile).string(), "its cases are not those that bundle.json names"});
  edit_report(3, [](Json& report) { report["cases"].erase(0); });
  expect_error(ErrorKind::kDamaged,
               {(shard(3) / kReportFile).string(), "its cases are not those that bundle.json names"});
  edit_report(3, [](Json& report) { report["cases"] = 7; });
  expect_error(ErrorKind::kDamaged, {(shard(3) / kReportFile).string()});
  edit_report(3, [](Json& report) { report = Json::array({1, 2}); });
  expect_error(ErrorKind::kDamaged, {(shard(3) / kReportFile).string()});
}

TEST_F(Merge, DoesNotWriteIntoAShard) {
  const Status into = prepare_merged_report(folders_, shard(3), "");
  ASSERT_FALSE(into.ok());
  EXPECT_TRUE(fs::exists(shard(3) / kBundleFile));
  EXPECT_FALSE(prepare_merged_report(folders_, shard(3) / "below", "").ok());
  EXPECT_FALSE(prepare_merged_report(folders_, out(), shard(3) / "junit.xml").ok());
}

TEST_F(Merge, TakesShardsWithoutACase) {
  const TemporarySuite suite;
  suite.add("only");
  suite.bless();
  folders_.resize(3);
  for (std::size_t k = 1; k <= 3; ++k) check_shard(suite, k, 3, shard(k));
  const Result<SuiteResult> merged = merge();
  ASSERT_TRUE(merged.ok()) << merged.error().message;
  EXPECT_TRUE(merged->passed());
  EXPECT_EQ(headline(*merged), "1 case passed: 1 unchanged");
}

TEST(Shards, KnowTheSuiteByItsFiles) {
  const TemporarySuite suite;
  suite.add("one");
  const auto hash = [&suite] { return suite_hash(*open_suite(suite.root())); };
  const std::string before = hash();
  EXPECT_EQ(hash(), before);
  suite.edit("one", kSceneFile, "steps = 30", "steps = 31");
  EXPECT_NE(hash(), before) << "the content of a file";
  suite.edit("one", kSceneFile, "steps = 31", "steps = 30");
  EXPECT_EQ(hash(), before);
  suite.write(suite.file("one", "more.txt"), "");
  EXPECT_NE(hash(), before) << "a file more";
}

TEST(Shards, StayWhenCasesComeAndGo) {
  // docs/sharding.md gives these: another program that assigns cases must agree.
  EXPECT_EQ(shard_of_name("brick_wall", 8), 7U);
  EXPECT_EQ(shard_of_name("tower_40", 8), 4U);
  Suite few, more;
  for (const char* name : {"a", "b", "c", "d", "e"}) more.cases.push_back({name, name});
  few.cases = {more.cases[1], more.cases[4]};
  for (std::size_t k = 1; k <= 3; ++k) {
    const Selection selection = {.names = {}, .category = "", .shard = k, .shards = 3};
    for (const CaseFolder& one : shard_of(few.cases, selection)) {
      const std::vector<CaseFolder> mine = shard_of(more.cases, selection);
      EXPECT_TRUE(std::ranges::any_of(mine, [&](const CaseFolder& other) { return other.name == one.name; }))
          << one.name;
    }
  }
}

}  // namespace
}  // namespace tumble::golden
