// Blessing changes what it says it changes, and refuses what would hide a failure.
#include "tumble/golden/bless.h"

#include <gtest/gtest.h>

#include <cmath>

#include "golden/bless/bless_log.h"
#include "golden/run/obstacle.h"
#include "golden/run/run_session.h"
#include "golden/suite/parse_rules.h"
#include "golden/suite/text_files.h"
#include "tests/support/golden_suite.h"
#include "tumble/replay/recorder.h"
#include "tumble/scenes/scene_file.h"

namespace tumble::golden {
namespace {

class Bless : public testing::Test {
 protected:
  void SetUp() override {
    suite_.add("fall");
    suite_.bless();
  }
  [[nodiscard]] Result<BlessReport> bless(const std::string& reason = "because", bool dry_run = false) const {
    return bless_cases({suite_.root(), {"fall"}, reason, dry_run, {}});
  }
  [[nodiscard]] std::string history() const { return suite_.read(suite_.root() / kHistoryFile); }
  TemporarySuite suite_;
};

TEST_F(Bless, WritesValuesAndKeepsBoundsAndComments) {
  const std::string rules = suite_.read(suite_.file("fall", kRulesFile));
  EXPECT_NE(rules.find("name = \"lost\"  # a comment that stays\nvalue = 0\nmax = 0\n"), std::string::npos) << rules;
  EXPECT_NE(rules.find("max = 100.0"), std::string::npos) << rules;
  EXPECT_NE(history().find("**fall**: new, 30 steps of 2 bodies. drift_max "), std::string::npos) << history();
}

TEST_F(Bless, OfTheSameAgainChangesNothing) {
  const std::string before = history();
  const Result<BlessReport> report = bless();
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_TRUE(report->blessed.empty());
  EXPECT_EQ(report->unchanged, std::vector<std::string>{"fall"});
  EXPECT_EQ(history(), before);
}

TEST_F(Bless, SaysWhatMovedByHowMuchAndWhy) {
  suite_.edit("fall", kSceneFile, "2.0]", "2.5]");
  EXPECT_FALSE(suite_.check().passed());
  const Result<BlessReport> report = bless("the upper box starts higher");
  ASSERT_TRUE(report.ok()) << report.error().message;
  ASSERT_EQ(report->blessed.size(), 1U);
  EXPECT_TRUE(suite_.check().passed());
  const std::string text = history();
  EXPECT_NE(text.find(": the upper box starts higher\n"), std::string::npos) << text;
  EXPECT_NE(text.find("first difference: step 0, phase start"), std::string::npos) << text;
  EXPECT_NE(text.find(" → "), std::string::npos) << text;
  EXPECT_LT(text.find("the upper box"), text.find("a test")) << "newest first";
}

TEST_F(Bless, DryRunWritesNothing) {
  suite_.edit("fall", kSceneFile, "2.0]", "2.5]");
  const std::string golden = suite_.read(suite_.file("fall", kExpectedFile));
  const std::string before = history();
  const Result<BlessReport> report = bless("because", true);
  ASSERT_TRUE(report.ok());
  EXPECT_EQ(report->blessed.size(), 1U);
  EXPECT_EQ(suite_.read(suite_.file("fall", kExpectedFile)), golden);
  EXPECT_EQ(history(), before);
}

// A folder stands for a file that may not be written: it stops root too.
TEST_F(Bless, AsksForEveryFileBeforeAnyCaseRuns) {
  suite_.edit("fall", kSceneFile, "2.0]", "2.5]");
  const auto refusal = [&] {
    BlessOptions options = {suite_.root(), {"fall"}, "because", false, {}};
    bool ran = false;
    options.pool.cancel = [&] { return ran = true; };
    const Result<BlessReport> report = bless_cases(options);
    EXPECT_FALSE(ran);
    EXPECT_TRUE(report.ok() || report.error().kind == ErrorKind::kBadInput);
    return report.ok() ? std::string("blessed") : report.error().message;
  };
  for (const std::filesystem::path& file : {suite_.root() / kHistoryFile, suite_.file("fall", kExpectedFile)}) {
    const std::string moved = file.string() + ".moved";
    std::filesystem::rename(file, moved);
    std::filesystem::create_directory(file);
    EXPECT_EQ(refusal(), file.string() + ": is a folder; name a file; nothing was blessed");
    std::filesystem::remove(file);
    std::filesystem::rename(moved, file);
  }
}

TEST_F(Bless, RefusesAMetricOutOfItsBounds) {
  suite_.edit("fall", kRulesFile, "max = 100.0", "max = 1e-9");
  const Result<BlessReport> report = bless();
  ASSERT_FALSE(report.ok());
  EXPECT_NE(report.error().message.find("drift_max"), std::string::npos) << report.error().message;
  EXPECT_NE(report.error().message.find("nothing was blessed"), std::string::npos) << report.error().message;
}

// A value that is no finite number would become null on its way, and the case would never pass again.
TEST(Obstacle, IsAValueThatIsInfiniteOrNotANumberWhateverItsBound) {
  CaseRun run;
  run.incomplete = "";
  MetricResult& metric = run.result.metrics.emplace_back();
  metric.rule.name = "kinetic_end";
  metric.unit = "J";
  metric.rule.min = 0;
  metric.value = 5;
  EXPECT_EQ(obstacle_to_bless(run, "metrics.toml"), "");
  for (const double value : {HUGE_VAL, -HUGE_VAL, static_cast<double>(NAN)}) {
    metric.value = value;
    EXPECT_TRUE(obstacle_to_bless(run, "metrics.toml").starts_with("kinetic_end is ")) << value;
  }
  metric.value = -1;
  EXPECT_TRUE(obstacle_to_bless(run, "metrics.toml").starts_with("kinetic_end is -1 J, below the bound by 1 J; if "));
  metric.value.reset();
  EXPECT_TRUE(obstacle_to_bless(run, "metrics.toml").starts_with("kinetic_end: null: "));
}

TEST(History, TellsTwoValuesApartInAsManyDigitsAsItTakes) {
  Blessing blessing{.name = "fall", .is_new = false, .bits = "same bits", .details = {}, .metrics = {}};
  MetricResult& metric = blessing.metrics.emplace_back();
  metric.rule.name = "drift_max";
  metric.unit = "m";
  metric.rule.value = 0.1;
  metric.value = 0.1000001;
  EXPECT_NE(history_entry("why", {blessing}).find("drift_max 0.1 m → 0.1000001 m."), std::string::npos)
      << history_entry("why", {blessing});
}

TEST_F(Bless, RefusesNoReasonAndUnknownCases) {
  EXPECT_FALSE(bless("  ").ok());
  EXPECT_FALSE(bless("two\nlines").ok());
  EXPECT_FALSE(bless_cases({suite_.root(), {"fail"}, "because", false, {}}).ok());
}

TEST_F(Bless, ReplacesADamagedGolden) {
  suite_.write(suite_.file("fall", kExpectedFile), "rubbish");
  EXPECT_FALSE(suite_.check().passed());
  ASSERT_TRUE(bless().ok());
  EXPECT_TRUE(suite_.check().passed());
}

TEST_F(Bless, MakesACaseOfARecordedSession) {
  const std::string log = suite_.root() / "session.tumble";
  replay::RecordOptions options;
  options.scene_text = kFallingBoxes;
  options.overrides = {"world.steps=20", "box.2.position=[0.1, 0.2, 2.25]"};
  const Result<sim::SceneDef> scene = scenes::parse_scene(kFallingBoxes, "s.toml", options.overrides);
  ASSERT_TRUE(scene.ok());
  ASSERT_TRUE(replay::record_session(log, *scene, options).ok());
  NewCase request{suite_.root(), "from_log", log, "seen in the field", false};
  const Result<BlessReport> report = bless_log(request);
  ASSERT_TRUE(report.ok()) << report.error().message;
  const CaseResult result = suite_.check_one("from_log");
  EXPECT_TRUE(result.passed()) << summary(result);
  EXPECT_EQ(result.steps, 20U);
  ASSERT_TRUE(result.blessed_by);
  EXPECT_GT(result.blessed_by->seconds, 0.0) << "the session was run once more";
  EXPECT_GE(result.metrics.size(), 5U);
  EXPECT_NE(history().find("seen in the field"), std::string::npos);
  EXPECT_FALSE(bless_log(request).ok()) << "the name is taken";
  request.name = "../escape";
  EXPECT_FALSE(bless_log(request).ok());
}

// A body that leaves the world ends its session: the log is whole, and each check of the case would fail.
TEST_F(Bless, NoCaseIsMadeOfASessionThatEndsEarly) {
  const std::string scene =
      "[world]\ndt = 0.1\ngravity = [0, 0, 0]\nground = false\n"
      "[[box]]\nposition = [32000, 0, 0.5]\nvelocity = [8000, 0, 0]\n";
  const Result<sim::SceneDef> parsed = scenes::parse_scene(scene, "scene.toml");
  ASSERT_TRUE(parsed.ok()) << parsed.error().message;
  const Result<Session> session = run_session(*parsed, scene);
  ASSERT_TRUE(session.ok() && !session->failure.empty());
  const std::string log = suite_.root() / "early.tumble";
  ASSERT_TRUE(write_file(log, std::span<const std::byte>(*session->log)).ok());
  const Result<BlessReport> report = bless_log({suite_.root(), "early", log, "seen in the field", false});
  ASSERT_FALSE(report.ok());
  EXPECT_NE(report.error().message.find("its scene ends early"), std::string::npos) << report.error().message;
}

TEST(CaseRules, ErrorsNameThePlaceAndWhatIsWanted) {
  const auto error_of = [](const std::string& text) {
    const Result<CaseRules> rules = parse_rules(text, "metrics.toml");
    return rules.ok() ? std::string("none") : rules.error().message;
  };
  EXPECT_NE(error_of("").find("at least one [[metric]]"), std::string::npos) << error_of("");
  const std::string good = "[[metric]]\nname = \"lost\"\nmax = 0\nwhy = \"w\"\n";
  EXPECT_EQ(error_of(good), "none");
  EXPECT_NE(error_of("[[metric]]\nname = \"drift_mx\"\nmax = 0\nwhy = \"w\"\n").find("did you mean \"drift_max\""),
            std::string::npos);
  EXPECT_NE(error_of("[[metric]]\nname = \"lost\"\nwhy = \"w\"\n").find("a bound"), std::string::npos);
  EXPECT_NE(error_of("[[metric]]\nname = \"lost\"\nmax = 0\n").find("reason"), std::string::npos);
  EXPECT_NE(error_of("[[metric]]\nname = \"lost\"\nmax = 0\nwhy = \" \"\n").find("reason"), std::string::npos);
  EXPECT_NE(error_of(good + "maxx = 1\n").find("unknown key"), std::string::npos);
  EXPECT_NE(error_of("require = [\"exakt\"]\n" + good).find("require"), std::string::npos);
  EXPECT_NE(error_of("require = []\n" + good).find("require"), std::string::npos);
  EXPECT_NE(error_of("[command]\nrun = \"engine {scene}\"\n" + good).find("{log}"), std::string::npos);
  EXPECT_NE(error_of(good + "bodies = \"everybody\"\n").find("everybody"), std::string::npos);
  EXPECT_EQ(error_of(good + "bodies = [1, 2]\naxis = \"y\"\nfrom_step = 3\n"), "none");
  EXPECT_EQ(error_of("require = [\"behaviour\"]\n" + good), "none");
}

}  // namespace
}  // namespace tumble::golden
