// The page of a check: what is drawn of failed cases, and that no text of a scene gets out of its place.
#include "tumble/golden/report.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "golden/judge/across_cases.h"
#include "golden/judge/case_series.h"
#include "golden/report/commands.h"
#include "golden/report/files.h"
#include "golden/report/html.h"
#include "golden/report/page/script.h"
#include "tests/support/golden_suite.h"

namespace tumble::golden {
namespace {

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

/// A suite with one case whose scene was changed after it was blessed.
class ChangedScene : public testing::Test {
 protected:
  void SetUp() override {
    suite_.add("falls");
    suite_.bless();
    suite_.edit("falls", "scene.toml", "position = [0.0, 0.0, 0.7]", "position = [0.0, 0.5, 0.7]");
  }
  [[nodiscard]] std::string page() const { return report_html(suite_.check(), suite_.root() / "report"); }
  [[nodiscard]] Json series() const {
    (void)suite_.check();
    return Json::parse(suite_.read(suite_.root() / "report/cases/falls" / kSeriesFile));
  }
  TemporarySuite suite_;
};

TEST_F(ChangedScene, SeriesHoldEveryStepAndWhatTheGoldenKeeps) {
  const Json series = this->series();
  EXPECT_EQ(series["actual"]["step"].size(), 31U);
  for (const char* column : {"kinetic", "potential", "total", "lateral_max", "height_max", "height_mean"}) {
    EXPECT_EQ(series["actual"][column].size(), 31U) << column;
  }
  EXPECT_EQ(series["expected"]["track"]["step"].size(), 31U);
  EXPECT_EQ(series["expected"]["states"]["step"].size(), 5U);
  // Both fell from the same heights, so that their energies agree where the golden has them.
  EXPECT_NEAR(series["expected"]["states"]["total"][0].get<double>(), series["actual"]["total"][0].get<double>(), 1e-3);
  EXPECT_NEAR(series["expected"]["track"]["height_max"][0].get<double>(), 2.0, 1e-9);
}

TEST_F(ChangedScene, FramesHaveEveryBodyWhereItIsAndWhereItWasExpected) {
  const Json series = this->series();
  EXPECT_EQ(series["bodies"]["id"], Json({1, 2}));
  EXPECT_EQ(series["bodies"]["size"].size(), 6U);
  const Json& frames = series["frames"];
  ASSERT_EQ(frames["step"].size(), 31U);
  EXPECT_EQ(frames["expected_mm"][0], Json({0, 0, 700, 100, 200, 2000}));
  EXPECT_EQ(frames["actual_mm"][0], Json({0, 500, 700, 100, 200, 2000}));
  EXPECT_EQ(frames["actual_turn"][0].size(), 8U);
}

TEST_F(ChangedScene, SeriesHoldNoWords) {
  suite_.edit("falls", "scene.toml", "two boxes fall", "</script>");
  const std::string text = this->series().dump();
  EXPECT_EQ(text.find("script"), std::string::npos);
  EXPECT_EQ(text.find('<'), std::string::npos);
}

TEST_F(ChangedScene, PageOfAFailureHasTheScriptAndItsNumbers) {
  const std::string page = this->page();
  EXPECT_EQ(count(page, "<div class=\"drawing\" data-first=\"0\" data-groups=\"stacking\">"), 1U);
  EXPECT_NE(page.find("\"expected_mm\""), std::string::npos);
  EXPECT_NE(page.find(report_script_pieces().front()), std::string::npos);
}

TEST_F(ChangedScene, PageHasTheCommandsToGoOnWith) {
  const std::string page = this->page();
  for (const char* begin : {"tumble record ", "tumble view falls.tumble --bounds ", "tumble check falls --suite ",
                            "tumble bless falls --suite "}) {
    EXPECT_EQ(count(page, std::string("<pre tabindex=\"0\">") + begin), 1U) << begin;
  }
}

TEST(NextCommands, BisectTheQuestionThatFailed) {
  CaseResult result;
  result.name = "falls";
  const auto last = [&](const std::string& suite) { return next_commands(result, suite).back().line; };
  result.verdict(VerdictKind::kExact).outcome = Outcome::kPass;
  result.verdict(VerdictKind::kImage).outcome = Outcome::kFail;
  EXPECT_EQ(last("golden"), "tumble bisect --good REV --bad HEAD --case falls --image");
  result.verdict(VerdictKind::kExact).outcome = Outcome::kFail;
  EXPECT_EQ(last("golden"), "tumble bisect --good REV --bad HEAD --case falls");
  EXPECT_EQ(last("elsewhere"), "tumble check falls --suite elsewhere") << "no clone to bisect";
}

TEST_F(ChangedScene, TextsOfACaseStayText) {
  suite_.edit("falls", "scene.toml", "two boxes fall",
              "</script><script>alert(1)</script><img src=x onerror=alert(2)>");
  suite_.edit("falls", "metrics.toml", "they fall straight", "</td><script>alert(3)</script>'");
  const std::string page = this->page();
  EXPECT_EQ(count(page, "<script>"), 1U) << "the page's own";
  EXPECT_EQ(page.find("<img"), std::string::npos);
  EXPECT_NE(page.find("&lt;script&gt;alert(1)"), std::string::npos);
  EXPECT_NE(page.find("&lt;script&gt;alert(3)"), std::string::npos);
}

TEST(AcrossCases, EachCaseIsCountedInOneSentence) {
  const auto sentences = [](std::initializer_list<std::uint64_t> steps) {
    std::vector<CaseResult> cases;
    for (const std::uint64_t step : steps) {
      FirstDifference& difference = cases.emplace_back().difference.emplace();
      difference.step = step;
      difference.phase = "integrate";
    }
    return across_cases(cases);
  };
  using Words = std::vector<std::string>;
  EXPECT_EQ(sentences({4}), Words{});
  EXPECT_EQ(sentences({1, 1, 1, 9}), Words{"3 of 4 first differ in step 1, phase integrate"});
  EXPECT_EQ(sentences({1, 1, 5, 5, 9}), Words{"5 of 5 first differ in phase integrate, in steps 1 to 9"});
  EXPECT_EQ(sentences({4, 30}), Words{"2 of 2 first differ in phase integrate, in steps 4 to 30"});
}

TEST(AcrossCases, WhatIsBehindTheThirdSentenceIsCounted) {
  std::vector<CaseResult> cases;
  for (const char* phase : {"a", "b", "c", "d", "e"}) {
    for (int k = 0; k < 2; ++k) cases.emplace_back().difference.emplace().phase = phase;
  }
  const std::vector<std::string> sentences = across_cases(cases);
  ASSERT_EQ(sentences.size(), 3U);
  EXPECT_TRUE(sentences.back().ends_with("phase c; 4 more in 2 further phases")) << sentences.back();
}

TEST(ReportPage, AValueThatIsNoNumberHasNoMargin) {
  SuiteResult result;
  CaseResult& one = result.cases.emplace_back();
  one.name = "lost";
  MetricResult& metric = one.metrics.emplace_back();
  metric.rule.name = "drift_max";
  metric.rule.max = 1;
  metric.unit = "m";
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    metric.value = value;
    const std::string page = report_html(result, testing::TempDir());
    EXPECT_EQ(count(page, "data-name=\"margin\">–<"), 1U) << value;
  }
  metric.value = 0.25;
  EXPECT_EQ(count(report_html(result, testing::TempDir()), "data-name=\"margin\">0.75 m<"), 1U);
}

TEST(ReportPage, OfAPassingRunNeedsNoScript) {
  TemporarySuite suite;
  suite.add("falls");
  suite.bless();
  const std::string page = report_html(suite.check(), suite.root() / "report");
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_LT(page.size(), 32'000U);  // of which the 174 canaries take most
}

TEST(ReportFiles, JsonCannotEndItsElementAndPicturesAreTakenIn) {
  const TemporarySuite suite;
  suite.write(suite.root() / "cases/a.json", R"({"a":"</script>"})");
  suite.write(suite.root() / "cases/a.png", "\x89PNG");
  ReportFiles files(suite.root());
  EXPECT_FALSE(files.is_drawn());
  EXPECT_EQ(files.json("cases/a.json").bytes(), R"({"a":"\u003c/script>"})");
  EXPECT_EQ(files.image_source("cases/a.png").bytes(), "data:image/png;base64,iVBORw==");
  EXPECT_EQ(files.image_source("cases/b.png").bytes(), "cases/b.png");
  EXPECT_EQ(files.image_source("cases/\"#?<.png").bytes(), "cases/%22%23%3F%3C.png");
  EXPECT_TRUE(files.is_drawn());
}

}  // namespace
}  // namespace tumble::golden
