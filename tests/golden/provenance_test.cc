// Where results come from: this run, the run that was blessed, the scene as it was then; and results of another machine
// that are accepted from its report.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "golden/bless/bless.h"
#include "golden/expected/expected_file.h"
#include "golden/report/html.h"
#include "golden/report/junit.h"
#include "golden/report/report.h"
#include "golden/suite/scene_changes.h"
#include "golden/suite/text_files.h"
#include "src/process/run_child.h"
#include "tests/support/golden_suite.h"

namespace tumble::golden {
namespace {

class Blessed : public testing::Test {
 protected:
  void SetUp() override {
    suite_.add("fall");
    suite_.bless();
  }
  /// Takes the scene's text and the provenance out of the golden, as if an older program had blessed it.
  void make_old() const {
    const std::string path = suite_.file("fall", kExpectedFile).string();
    const std::string bytes = suite_.read(path);
    Result<Expected> golden = unpack(std::as_bytes(std::span(bytes)), path);
    ASSERT_TRUE(golden.ok()) << golden.error().message;
    golden->scene_text.clear();
    golden->provenance = {};
    golden->provenance.version = "0.0.9";
    const Result<std::vector<std::byte>> old = pack(*golden);
    suite_.write(path, std::string(reinterpret_cast<const char*>(old->data()), old->size()));
  }
  TemporarySuite suite_;
};

TEST_F(Blessed, ThisRunAndTheBlessedOneAreInPageJsonAndJunit) {
  suite_.edit("fall", kRulesFile, "max = 100.0", "max = 1e-9");
  const SuiteResult result = suite_.check();
  const Json json = report_json(result);
  for (const Json& from : {json["run"], json["cases"][0]["blessed_by"]}) {
    for (const char* key : {"version", "compiler", "machine", "date"}) {
      EXPECT_NE(from[key].get<std::string>(), "") << key;
    }
    EXPECT_GT(from["seconds"].get<double>(), 0.0);
    EXPECT_TRUE(from.contains("commit") && from.contains("tree"));
  }
  const std::string page = report_html(result, suite_.root() / "report");
  const std::string junit = report_junit(result);
  const std::string date = json["run"]["date"];
  EXPECT_NE(page.find("this run: tumble "), std::string::npos);
  EXPECT_NE(page.find("blessed: tumble "), std::string::npos);
  EXPECT_NE(page.find(date), std::string::npos);
  EXPECT_NE(junit.find("name=\"run\" value=\"tumble "), std::string::npos);
  EXPECT_NE(junit.find("name=\"blessed fall\" value=\"tumble "), std::string::npos);
}

TEST_F(Blessed, AnOldGoldenSaysThatItKeepsNeither) {
  make_old();
  const CaseResult same = suite_.check_one("fall");
  EXPECT_TRUE(same.passed()) << summary(same);
  ASSERT_TRUE(same.blessed_by);
  EXPECT_NE(describe(*same.blessed_by).find("0.0.9; no more is known"), std::string::npos);
  suite_.edit("fall", kSceneFile, "2.0]", "2.5]");
  const CaseResult stale = suite_.check_one("fall");
  ASSERT_FALSE(stale.problems.empty());
  EXPECT_NE(stale.problems[0].find("older than the goldens that keep the scene's text"), std::string::npos);
}

TEST_F(Blessed, AStaleGoldenNamesTheLinesThatChanged) {
  suite_.edit("fall", kSceneFile, "2.0]", "2.5]");
  const SuiteResult result = suite_.check();
  const CaseResult& stale = result.cases.at(0);
  ASSERT_EQ(stale.scene_changes.size(), 1U);
  ASSERT_FALSE(stale.problems.empty());
  const std::string words = "line 10, [[box]]: position = [0.1, 0.2, 2.0] → [0.1, 0.2, 2.5]";
  EXPECT_NE(stale.problems[0].find(words), std::string::npos) << stale.problems[0];
  EXPECT_EQ(report_json(result)["cases"][0]["scene_changes"][0]["line"], 10);
  EXPECT_NE(report_html(result, suite_.root() / "report").find(words), std::string::npos);
}

TEST(SceneChanges, ComeGoAndMoveWithTheirTablesAndWithoutWordsAndLooks) {
  const auto words = [](std::string_view before, std::string_view after) {
    std::string all;
    for (const SceneChange& change : scene_changes(before, after)) all += describe(change) + '\n';
    return all;
  };
  EXPECT_EQ(words("a = 1\n", "a = 1 # why\n\n  # more\n"), "");
  EXPECT_EQ(words("title = \"a\"\n[camera]\nfov = 3\n", "title = \"b\"\n[camera]\nfov = 4\n"), "");
  EXPECT_EQ(words("[world]\ndt = 0.1\nsteps = 3\n", "[world]\nsteps = 3\n"),
            "line 2 of the old scene, [world]: gone: dt = 0.1\n");
  EXPECT_EQ(words("[[box]]\nmass = 1\n[[box]]\nmass = 2\n", "[[box]]\nmass = 1\n[[box]]\nfrozen = true\nmass = 3\n"),
            "line 4, [[box]]: new: frozen = true\nline 5, [[box]]: mass = 2 → 3\n");
  EXPECT_EQ(words("a = \"x # y\"\n", "a = \"x # z\"\n"), "line 1: a = \"x # y\" → \"x # z\"\n");
}

/// A clone with a suite whose case changed, and the report of its check.
class FromReport : public testing::Test {
 protected:
  void SetUp() override {
    suite_.add("fall");
    suite_.add("rest");
    suite_.bless();
    git({"init", "-q"});
    suite_.edit("fall", kSceneFile, "2.0]", "2.5]");
    commit();
    write_report("clean");
  }
  void git(std::vector<std::string> words) const {
    words.insert(words.begin(), {"git", "-c", "user.name=a", "-c", "user.email=a@b", "-c", "commit.gpgsign=false"});
    process::Program program;
    program.words = words;
    program.folder = suite_.root();
    program.out = suite_.root() / "git.txt";
    const Result<process::ChildEnd> end = process::run_child(program);
    ASSERT_TRUE(end.ok() && end->well()) << words.back();
  }
  void commit() const {
    git({"add", "cases", "HISTORY.md"});
    git({"commit", "-q", "--allow-empty", "-m", "a change"});
  }
  [[nodiscard]] std::string head() const {
    git({"rev-parse", "HEAD"});
    const std::string all = suite_.read(suite_.root() / "git.txt");
    return all.substr(all.size() - 41, 40);
  }
  void write_report(const std::string& tree) const {
    SuiteResult result = suite_.check();
    result.run.commit = head();
    result.run.tree = tree;
    ASSERT_TRUE(write_reports(result, suite_.root() / "report", "").ok());
  }
  [[nodiscard]] Result<BlessReport> bless() const {
    BlessOptions options;
    options.suite = suite_.root();
    options.reason = "as the other machine ran it";
    options.report = suite_.root() / "report";
    return bless_cases(options);
  }
  void refuses(const std::string& words) const {
    const Result<BlessReport> report = bless();
    ASSERT_FALSE(report.ok()) << words;
    EXPECT_NE(report.error().message.find(words), std::string::npos) << report.error().message;
  }
  TemporarySuite suite_;
};

TEST_F(FromReport, OfThisCommitIsAccepted) {
  EXPECT_FALSE(suite_.check().passed());
  write_report("clean");  // the check removed the one before
  const Result<BlessReport> report = bless();
  ASSERT_TRUE(report.ok()) << report.error().message;
  ASSERT_EQ(report->blessed.size(), 1U);
  EXPECT_EQ(report->blessed[0].name, "fall");
  const CaseResult result = suite_.check_one("fall");
  EXPECT_TRUE(result.passed()) << summary(result);
  ASSERT_TRUE(result.blessed_by);
  EXPECT_EQ(result.blessed_by->commit, head()) << "of the run that was accepted";
}

TEST_F(FromReport, OfAnotherCommitOrTreeOrSceneIsRefused) {
  write_report("changed");
  refuses("with changed sources");
  write_report("");
  refuses("does not say which commit");
  write_report("clean");
  suite_.edit("fall", kSceneFile, "2.5]", "2.25]");
  refuses("is of another scene");
  commit();
  refuses("check that commit out first");
}

TEST_F(FromReport, WithADamagedSessionIsRefused) {
  const std::filesystem::path log = suite_.root() / "report/cases/fall/actual.tumble";
  std::string bytes = suite_.read(log);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  suite_.write(log, bytes);
  EXPECT_FALSE(bless().ok());
  std::filesystem::remove(log);
  refuses("holds no session of a failed case");
  suite_.write(suite_.root() / "report/report.json", "{}");
  refuses("is no report of a check");
}

}  // namespace
}  // namespace tumble::golden
