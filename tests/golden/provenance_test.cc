// Where results come from: this run, the run that was blessed, the scene as it was then.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "golden/expected/expected_file.h"
#include "golden/report/html.h"
#include "golden/report/junit.h"
#include "golden/report/report_json.h"
#include "golden/suite/text_files.h"
#include "tests/support/golden_suite.h"
#include "tumble/golden/scene_changes.h"

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
  EXPECT_NE(stale.problems[0].find("does not keep the scene's text"), std::string::npos) << stale.problems[0];
}

TEST_F(Blessed, AGoldenOfALongSceneSaysThatItKeepsNoText) {
  suite_.edit("fall", kSceneFile, "title", "#" + std::string(kSceneTextMax, 'x') + "\ntitle");
  suite_.edit("fall", kSceneFile, "2.0]", "2.25]");
  suite_.bless();
  suite_.edit("fall", kSceneFile, "2.25]", "2.5]");
  const CaseResult stale = suite_.check_one("fall");
  ASSERT_FALSE(stale.problems.empty());
  EXPECT_NE(stale.problems[0].find("does not keep the scene's text"), std::string::npos) << stale.problems[0];
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
  EXPECT_EQ(words("a = \"\\\" # y\"\n", "a = \"\\\" # z\"\n"), "line 1: a = \"\\\" # y\" → \"\\\" # z\"\n");
  EXPECT_EQ(words("[material]\ntexture = \"wood\"\n", "[material]\ntexture = \"brick\"\n"), "");
}

TEST(SceneChanges, OfATextOverSeveralLinesAreNoTablesAndNoComments) {
  const std::string title = "title = \"\"\"\none\n[world]\n# two\n\"\"\"\n";
  const std::string other = "title = '''\nthree\n[camera]\n'''\n";
  EXPECT_TRUE(scene_changes(title + "a = 1\n", other + "a = 1\n").empty());
  const std::vector<SceneChange> changes = scene_changes(title + "a = 1\n", title + "a = 2\n");
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(describe(changes[0]), "line 6: a = 1 → 2");
}

TEST(SceneChanges, OfALongSceneAreFewWhereOneLineCame) {
  std::string boxes;
  for (int i = 0; i < 2500; ++i) boxes += "[[box]]\nmass = " + std::to_string(i) + "\n";
  std::string more = boxes;
  more.insert(more.find("[[box]]\nmass = 9\n"), "frozen = true\n");
  const std::vector<SceneChange> changes = scene_changes(boxes, more);
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].after, "frozen = true");
}

}  // namespace
}  // namespace tumble::golden
