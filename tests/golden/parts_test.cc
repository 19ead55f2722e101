// The parts of the suite by themselves: canaries that a bad judge does not see, files, reports.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <set>

#include "golden/canaries/canaries.h"
#include "golden/expected/expected_file.h"
#include "golden/report/junit.h"
#include "golden/report/report_json.h"
#include "golden/run/run_session.h"
#include "golden/suite/scene_hash.h"
#include "golden/suite/text_files.h"
#include "src/base/rng.h"
#include "tests/support/golden_suite.h"
#include "tumble/golden/suite.h"
#include "tumble/scenes/scene_file.h"

namespace tumble::golden {
namespace {

// The commands that a report prints would take it for an option.
TEST(CaseNames, BeginWithNoDash) {
  for (const char* name : {"a", "_a", "9", "a-b"}) EXPECT_TRUE(check_case_name(name).ok()) << name;
  for (const char* name : {"-a", "--", "-", "", "a b"}) EXPECT_FALSE(check_case_name(name).ok()) << name;
}

TEST(Canaries, AreAllCaughtByTheJudge) {
  const CanaryRoll roll = run_canaries();
  EXPECT_EQ(roll.results().size(), roll.names().size());
  EXPECT_GE(roll.results().size(), 25U);
  for (const CanaryResult& one : roll.results()) EXPECT_FALSE(one.missed()) << one.name << ": " << one.message;
}

TEST(Canaries, AreAskedInOneShardEach) {
  constexpr std::size_t kOfThree = 3;
  std::vector<std::string> all, asked;
  for (std::size_t k = 1; k <= kOfThree; ++k) {
    const CanaryRoll roll = run_canaries(judge, k, kOfThree);
    all = all.empty() ? roll.names() : all;
    EXPECT_EQ(roll.names(), all) << "each shard knows those of all";
    EXPECT_LT(roll.results().size(), all.size());
    for (const CanaryResult& one : roll.results()) {
      EXPECT_FALSE(one.missed()) << one.name << ": " << one.message;
      asked.push_back(one.name);
    }
  }
  EXPECT_EQ(std::set<std::string>(all.begin(), all.end()).size(), all.size()) << "no name is there twice";
  std::ranges::sort(all);
  std::ranges::sort(asked);
  EXPECT_EQ(asked, all);
}

TEST(Canaries, ThatCouldNotBeAskedAreSaid) {
  SuiteResult result;
  result.canaries = {{"one", true, "seen", "suite"}, {"two", false, "no OpenGL", "suite", false}};
  result.facts.canaries = {"one", "two", "three"};
  EXPECT_TRUE(result.canaries_caught());
  EXPECT_EQ(result.canaries_text(), "1 of 1 canary caught, 1 not asked, 1 fell to other shards");
  result.canaries.clear();
  EXPECT_FALSE(result.canaries_caught()) << "a check asks some";
  result.shards = 5;
  EXPECT_TRUE(result.canaries_caught());
  EXPECT_EQ(result.canaries_text(), "no canary, 3 fell to other shards");
}

// Its canaries take a while, and a bundle would call the check whole.
TEST(Shard, WithoutACaseCanBeInterrupted) {
  const TemporarySuite suite;
  suite.add("one");
  CheckOptions options;
  options.suite = suite.root();
  options.selection.shards = 2;
  options.selection.shard = 3 - shard_of_name("one", options.selection.shards);
  const Result<SuiteResult> whole = check_suite(options);
  ASSERT_TRUE(whole.ok()) << whole.error().message;
  EXPECT_TRUE(whole->cases.empty());
  options.pool.cancel = [] { return true; };
  const Result<SuiteResult> cancelled = check_suite(options);
  ASSERT_FALSE(cancelled.ok()) << "it is called finished";
  EXPECT_EQ(cancelled.error().kind, ErrorKind::kCannotFinish);
  EXPECT_NE(cancelled.error().message.find("interrupted"), std::string::npos) << cancelled.error().message;
}

TEST(Headline, CountsTheVerdictsOfCasesThatFailed) {
  SuiteResult result;
  result.canaries = {{"one", true, "", "suite"}};
  result.cases.resize(2);
  CaseResult &moved = result.cases[0], &broken = result.cases[1];
  for (CaseResult* one : {&moved, &broken}) one->require = {VerdictKind::kBehaviour};
  moved.verdict(VerdictKind::kExact).outcome = Outcome::kFail;
  moved.verdict(VerdictKind::kBehaviour).outcome = Outcome::kPass;
  broken.verdict(VerdictKind::kExact).outcome = Outcome::kPass;
  broken.verdict(VerdictKind::kBehaviour).outcome = Outcome::kFail;
  EXPECT_EQ(headline(result), "1 of 2 cases failed; verdicts failed: behaviour 1");
}

Judged always_pleased(replay::LogReader& log, const Reference& reference) {
  Judged judged = judge(log, reference);
  judged.result.problems.clear();
  judged.result.difference.reset();
  for (Verdict& verdict : judged.result.verdicts) verdict.outcome = Outcome::kPass;
  return judged;
}

Judged blind_to_the_last_state(replay::LogReader& log, const Reference& reference) {
  Judged judged = judge(log, reference);
  if (judged.result.difference && judged.result.difference->step == log.step_count()) {
    judged.result.verdict(VerdictKind::kExact) = {Outcome::kPass, "same"};
  }
  return judged;
}

Judged never_pleased(replay::LogReader& log, const Reference& reference) {
  Judged judged = judge(log, reference);
  judged.result.problems.emplace_back("no");
  return judged;
}

TEST(Canaries, ShowAJudgeThatSeesNothingOrTooMuch) {
  for (const Judge sabotaged : {always_pleased, blind_to_the_last_state, never_pleased}) {
    EXPECT_TRUE(std::ranges::any_of(run_canaries(sabotaged).results(), &CanaryResult::missed));
  }
  const TemporarySuite suite;
  suite.add("fall");
  suite.bless();
  CheckOptions options;
  options.suite = suite.root();
  options.canary_judge = always_pleased;
  const Result<SuiteResult> result = check_suite(options);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->failed_cases(), 0U);
  EXPECT_FALSE(result->passed());
}

// No build can be told by files that could not be written.
TEST(Canaries, AreNotBlamedForADiskThatBecameFull) {
  const TemporarySuite suite;
  suite.add("fall");
  suite.bless();
  CheckOptions options;
  options.suite = suite.root();
  options.canary_judge = [](replay::LogReader& log, const Reference& reference) {
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit = {};
    ::getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = 1000;
    ::setrlimit(RLIMIT_FSIZE, &limit);
    return judge(log, reference);
  };
  const Result<SuiteResult> result = check_suite(options);
  rlimit limit = {};
  ::getrlimit(RLIMIT_FSIZE, &limit);
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_FSIZE, &limit);
  ASSERT_FALSE(result.ok()) << "a canary is blamed";
  EXPECT_EQ(result.error().kind, ErrorKind::kCannotFinish);
  EXPECT_NE(result.error().message.find(": no temporary files can be written: "), std::string::npos)
      << result.error().message;
}

TEST(Canaries, AreAskedOnceNothingIsWrongWithTheSuite) {
  const TemporarySuite suite;
  suite.add("fall", kFallingBoxes, "[engine]\nscene = \"scene.toml\"\n" + std::string(kTwoMetrics));
  static int asked = 0;
  CheckOptions options;
  options.suite = suite.root();
  options.canary_judge = [](replay::LogReader& log, const Reference& reference) {
    ++asked;
    return judge(log, reference);
  };
  EXPECT_FALSE(check_suite(options).ok()) << "it has no tumble.toml";
  EXPECT_EQ(asked, 0) << "seconds of a wait for a message";
}

/// What a golden of the falling boxes holds.
Expected some_golden() {
  const Result<sim::SceneDef> scene = scenes::parse_scene(kFallingBoxes, "s.toml");
  const Result<Session> session = run_session(*scene, kFallingBoxes);
  Result<replay::LogReader> log = open_session(*session, "log");
  const CaseRules rules;
  return judge(*log, {rules, nullptr, scene_hash(*scene), session->continuation}).actual;
}

TEST(Expected, ReadsBackAsItWasWritten) {
  const Expected golden = some_golden();
  ASSERT_EQ(golden.steps(), 30U);
  EXPECT_EQ(golden.states.front().step, 0U);
  EXPECT_EQ(golden.states.back().step, 30U);
  EXPECT_NE(golden.continuation, Hash128{});
  const Result<std::vector<std::byte>> file = pack(golden);
  ASSERT_TRUE(file.ok()) << file.error().message;
  const Result<Expected> again = unpack(*file, "golden");
  ASSERT_TRUE(again.ok()) << again.error().message;
  EXPECT_EQ(*again, golden);
}

TEST(Expected, LargeSessionsLosePhaseDetailBeforeAnythingElse) {
  Expected golden = some_golden();
  for (std::vector<std::uint16_t>& words : golden.phase_words) {
    for (std::size_t i = 0; i < 40'000; ++i) words.push_back(static_cast<std::uint16_t>(random_bits(1, i, words[0])));
    words.resize(words.size() / golden.phases.size() * golden.phases.size());
  }
  const Result<std::vector<std::byte>> file = pack(golden);
  ASSERT_TRUE(file.ok());
  EXPECT_LE(file->size(), kGoldenBytesWanted);
  const Result<Expected> again = unpack(*file, "golden");
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->phase_detail, PhaseDetail::kStep);
  EXPECT_EQ(again->state_hashes, golden.state_hashes);
  EXPECT_EQ(again->states, golden.states);
}

TEST(SceneHash, CoversEveryNumberThatMatters) {
  const sim::SceneDef scene = *scenes::parse_scene(kFallingBoxes, "s.toml");
  const auto differs = [&](auto change) {
    sim::SceneDef other = scene;
    change(other);
    return scene_hash(other) != scene_hash(scene);
  };
  EXPECT_TRUE(differs([](sim::SceneDef& s) { s.steps += 1; }));
  EXPECT_TRUE(differs([](sim::SceneDef& s) { s.world.dt *= 1.0000001; }));
  EXPECT_TRUE(differs([](sim::SceneDef& s) { s.world.slip_speed *= 2; }));
  EXPECT_TRUE(differs([](sim::SceneDef& s) { s.world.freezing = false; }));
  EXPECT_TRUE(differs([](sim::SceneDef& s) { s.boxes[1].material.restitution = 0.9; }));
  EXPECT_TRUE(differs([](sim::SceneDef& s) { s.boxes[1].origin.row = 7; }));
  EXPECT_TRUE(differs([](sim::SceneDef& s) { s.inputs.push_back({3, sim::Wake{1}}); }));
  EXPECT_FALSE(differs([](sim::SceneDef& s) { s.title = "another"; }));
  EXPECT_FALSE(differs([](sim::SceneDef& s) { s.camera.fov = 10; }));
}

TEST(Report, JunitIsXmlThatCountsItsFailures) {
  const TemporarySuite suite;
  suite.add("fall");
  suite.add("new <one> \"quoted\" & more");
  suite.bless();
  suite.edit("fall", kRulesFile, "max = 100.0", "max = 1e-9");
  const SuiteResult result = suite.check();
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(report_junit(result).c_str()));
  const pugi::xml_node junit = document.child("testsuites").child("testsuite");
  EXPECT_EQ(junit.attribute("tests").as_int(), 3);
  EXPECT_EQ(junit.attribute("failures").as_int(), 1);
  EXPECT_EQ(std::distance(junit.children("testcase").begin(), junit.children("testcase").end()), 3);
  const pugi::xml_node fall = junit.find_child_by_attribute("testcase", "name", "fall");
  EXPECT_TRUE(
      std::string_view(fall.child("failure").attribute("message").value()).starts_with("1 of 2 metrics failed: "));
  EXPECT_TRUE(junit.find_child_by_attribute("testcase", "name", "new <one> \"quoted\" & more"));
}

TEST(Report, JsonAndPageNameWhatFailedAndTheCommands) {
  const TemporarySuite suite;
  suite.add("fall");
  suite.bless();
  suite.edit("fall", kRulesFile, "max = 100.0", "max = 1e-9");
  const SuiteResult result = suite.check();
  const Json json = report_json(result);
  EXPECT_EQ(json["passed"], false);
  EXPECT_EQ(json["failed_verdicts"]["behaviour"], 1);
  EXPECT_EQ(json["failed_verdicts"]["exact"], 0);
  const Result<CaseResult> again = case_from_json(json["cases"][0].dump());
  ASSERT_TRUE(again.ok()) << again.error().message;
  EXPECT_EQ(to_json(*again), json["cases"][0]);
}

TEST(Report, JsonCountsTheVerdictsOfFailedCasesAsItsHeadlineDoes) {
  const TemporarySuite suite;
  suite.add("fall");
  suite.bless();
  suite.edit("fall", kRulesFile, "max = 100.0", "max = 1e-9");
  suite.write(suite.root() / "cases" / "fall" / kRulesFile,
              "require = [\"exact\"]\n" + *read_text(suite.root() / "cases" / "fall" / kRulesFile));
  const SuiteResult result = suite.check();
  ASSERT_TRUE(result.passed()) << headline(result);
  EXPECT_EQ(result.cases.at(0).verdict(VerdictKind::kBehaviour).outcome, Outcome::kFail);
  EXPECT_EQ(report_json(result)["failed_verdicts"]["behaviour"], 0);
  SuiteResult failed = result;
  failed.cases.at(0).require = {VerdictKind::kBehaviour};
  failed.cases.at(0).verdict(VerdictKind::kExact).outcome = Outcome::kFail;
  EXPECT_EQ(report_json(failed)["failed_verdicts"]["behaviour"], 1);
  EXPECT_EQ(report_json(failed)["failed_verdicts"]["exact"], 0) << "it does not decide";
}

}  // namespace
}  // namespace tumble::golden
