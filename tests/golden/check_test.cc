// A check passes what is right and nothing else: every way in which a case can be wrong, one at a time.
#include "tumble/golden/check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "golden/expected/expected_file.h"
#include "golden/run/external_engine.h"
#include "src/process/run_child.h"
#include "tests/support/golden_suite.h"
#include "tumble/golden/bless.h"
#include "tumble/sim/step.h"

namespace tumble::golden {
namespace {

Outcome exact_of(const CaseResult& result) { return result.verdict(VerdictKind::kExact).outcome; }
Outcome behaviour_of(const CaseResult& result) { return result.verdict(VerdictKind::kBehaviour).outcome; }

bool has_problem(const CaseResult& result, const std::string& words) {
  return std::ranges::any_of(result.problems, [&](const std::string& p) { return p.find(words) != std::string::npos; });
}

/// A blessed suite with one case, "fall".
class OneCase : public testing::Test {
 protected:
  void SetUp() override {
    suite_.add("fall");
    suite_.bless();
  }
  TemporarySuite suite_;
};

TEST_F(OneCase, PassesAsBlessed) {
  const SuiteResult result = suite_.check();
  EXPECT_TRUE(result.passed());
  ASSERT_EQ(result.cases.size(), 1U);
  EXPECT_EQ(summary(result.cases[0]), "same bits, 2 metrics unmoved");
  EXPECT_EQ(change_of(result.cases[0]), Change::kNone);
  EXPECT_EQ(headline(result), "1 case passed: 1 unchanged");
  EXPECT_EQ(result.cases[0].steps, 30U);
  EXPECT_EQ(result.cases[0].bodies, 2U);
  EXPECT_FALSE(std::filesystem::exists(suite_.root() / "report" / "cases" / "fall"));
}

TEST_F(OneCase, BitsThatMoveWithoutBehaviourReadAsThat) {
  suite_.edit("fall", kSceneFile, "2.0]", "2.000000001]");
  const CaseResult result = suite_.check_one("fall");
  EXPECT_FALSE(result.passed());
  EXPECT_EQ(exact_of(result), Outcome::kFail);
  EXPECT_EQ(behaviour_of(result), Outcome::kPass);
  for (const char* words :
       {"e-09 m apart (body ", "), bits moved from step 0; 1 of 2 metrics moved within bounds, most: drift_max "}) {
    EXPECT_NE(summary(result).find(words), std::string::npos) << summary(result);
  }
  EXPECT_TRUE(summary(result).ends_with("; stale")) << summary(result);
  EXPECT_EQ(change_of(result), Change::kWithinBounds);
  EXPECT_TRUE(has_problem(result, "stale"));
  ASSERT_TRUE(result.difference);
  EXPECT_EQ(result.difference->step, 0U);
  EXPECT_EQ(result.difference->phase, "start");
  const std::string details = testing::PrintToString(result.difference->details);
  EXPECT_NE(details.find("body 2, position.z, 1.004e-09 m: expected 2, actual 2.0000000010"), std::string::npos)
      << details;
  EXPECT_TRUE(std::filesystem::exists(suite_.root() / "report" / "cases" / "fall" / "actual.tumble"));
}

// Another definition of phase hashes is no other physics: states, metrics and the hidden end still compare.
TEST_F(OneCase, PhaseHashesOfAnotherVersionAreStaleAndNoDifference) {
  const std::string path = suite_.file("fall", kExpectedFile).string();
  const std::string bytes = suite_.read(path);
  Result<Expected> golden = unpack(std::as_bytes(std::span(bytes)), path);
  ASSERT_TRUE(golden.ok()) << golden.error().message;
  --golden->phase_hash_version;
  for (std::uint32_t& word : golden->step_words) word ^= 5;
  for (std::vector<std::uint16_t>& words : golden->phase_words) words.front() ^= 5;
  const Result<std::vector<std::byte>> old = pack(*golden);
  suite_.write(path, std::string(reinterpret_cast<const char*>(old->data()), old->size()));
  const CaseResult result = suite_.check_one("fall");
  EXPECT_FALSE(result.passed());
  EXPECT_EQ(exact_of(result), Outcome::kPass) << result.verdict(VerdictKind::kExact).message;
  EXPECT_EQ(behaviour_of(result), Outcome::kPass);
  const auto version = [](std::uint32_t number) { return "version " + std::to_string(number); };
  EXPECT_TRUE(has_problem(result, "stale: blessed with phase hashes of " + version(sim::PhaseHashes::kVersion - 1) +
                                      ", run with " + version(sim::PhaseHashes::kVersion)));

  ASSERT_TRUE(bless_cases({suite_.root(), {"fall"}, "because", false, {}}).ok());
  EXPECT_TRUE(suite_.check_one("fall").passed());

  golden->state_hashes.back().low ^= 1;
  const Result<std::vector<std::byte>> wrong = pack(*golden);
  suite_.write(path, std::string(reinterpret_cast<const char*>(wrong->data()), wrong->size()));
  EXPECT_EQ(exact_of(suite_.check_one("fall")), Outcome::kFail);
}

TEST_F(OneCase, CommentsAndLooksDoNotMakeAGoldenStale) {
  suite_.edit("fall", kSceneFile, "[world]", "# a comment\n[camera]\nfov = 50.0\n[world]");
  EXPECT_TRUE(suite_.check_one("fall").passed());
}

TEST_F(OneCase, BoundsDecideBehaviour) {
  suite_.edit("fall", kRulesFile, "max = 100.0", "max = 1e-9");
  const CaseResult result = suite_.check_one("fall");
  EXPECT_FALSE(result.passed());
  EXPECT_EQ(exact_of(result), Outcome::kPass);
  EXPECT_EQ(behaviour_of(result), Outcome::kFail);
  EXPECT_TRUE(summary(result).starts_with("1 of 2 metrics failed: drift_max ")) << summary(result);
  EXPECT_TRUE(summary(result).ends_with("; same bits")) << summary(result);
  EXPECT_NE(result.metrics[0].message.find("above the bound by"), std::string::npos) << result.metrics[0].message;
}

TEST_F(OneCase, AValueThatMovesWithoutABitFails) {
  std::string rules = suite_.read(suite_.file("fall", kRulesFile));
  const std::size_t at = rules.find("value = ");
  suite_.edit("fall", kRulesFile, rules.substr(at, rules.find('\n', at) - at), "value = 0.5");
  const CaseResult result = suite_.check_one("fall");
  EXPECT_EQ(behaviour_of(result), Outcome::kFail);
  const std::string& message = result.metrics[0].message;
  EXPECT_NE(message.find("within its bound, but not the golden's value though no bit moved"), std::string::npos)
      << message;
  EXPECT_EQ(change_of(result), Change::kWithinBounds) << "its bounds hold";
}

TEST_F(OneCase, NullFailsUnlessTheCaseAllowsIt) {
  const std::string more = "\n[[metric]]\nname = \"column_spread\"\nmax = 0\nwhy = \"there is no grid here\"\n";
  suite_.write(suite_.file("fall", kRulesFile), suite_.read(suite_.file("fall", kRulesFile)) + more);
  EXPECT_EQ(behaviour_of(suite_.check_one("fall")), Outcome::kFail);
  suite_.edit("fall", kRulesFile, "max = 0\nwhy = \"there is no", "max = 0\nmay_be_null = true\nwhy = \"there is no");
  EXPECT_EQ(behaviour_of(suite_.check_one("fall")), Outcome::kPass);
}

TEST_F(OneCase, MissingFilesFail) {
  std::filesystem::remove(suite_.file("fall", kExpectedFile));
  CaseResult result = suite_.check_one("fall");
  EXPECT_FALSE(result.passed());
  EXPECT_TRUE(has_problem(result, "no expected.tumble"));
  std::filesystem::remove(suite_.file("fall", kRulesFile));
  result = suite_.check_one("fall");
  EXPECT_TRUE(has_problem(result, "no metrics.toml"));
  std::filesystem::remove(suite_.file("fall", kSceneFile));
  result = suite_.check_one("fall");
  EXPECT_FALSE(result.passed());
  EXPECT_TRUE(has_problem(result, "no scene.toml"));
}

TEST_F(OneCase, UnreferencedFilesFail) {
  suite_.write(suite_.file("fall", "notes.txt"), "hello");
  EXPECT_TRUE(has_problem(suite_.check_one("fall"), "unreferenced"));
  EXPECT_FALSE(suite_.check_one("fall").passed());
}

TEST_F(OneCase, AFileBesideTheCasesFails) {
  suite_.write(suite_.root() / "cases" / "stray.toml", "");
  const SuiteResult result = suite_.check();
  EXPECT_FALSE(result.passed());
  EXPECT_EQ(result.failed_cases(), 0U);
}

// Every byte of a golden is covered: whichever is changed, and wherever the file ends, the check fails.
TEST_F(OneCase, DamagedTornOrEmptyGoldensFail) {
  const std::string whole = suite_.read(suite_.file("fall", kExpectedFile));
  for (std::size_t k = 0; k <= 6; ++k) {
    std::string damaged = whole;
    damaged[k * (whole.size() - 1) / 6] ^= 4;
    suite_.write(suite_.file("fall", kExpectedFile), damaged);
    EXPECT_FALSE(suite_.check_one("fall").passed()) << "byte " << k * (whole.size() - 1) / 6;
  }
  for (const std::size_t size : {std::size_t{0}, std::size_t{64}, std::size_t{128}, whole.size() - 1}) {
    suite_.write(suite_.file("fall", kExpectedFile), whole.substr(0, size));
    EXPECT_FALSE(suite_.check_one("fall").passed()) << size;
  }
  suite_.write(suite_.file("fall", kExpectedFile), whole + whole);
  EXPECT_FALSE(suite_.check_one("fall").passed());
  suite_.write(suite_.file("fall", kExpectedFile), whole);
  EXPECT_TRUE(suite_.check_one("fall").passed());
}

TEST_F(OneCase, RequireChoosesWhatDecides) {
  suite_.edit("fall", kSceneFile, "title", "# moved by hand\ntitle");
  suite_.edit("fall", kRulesFile, "max = 100.0", "max = 1e-9");
  const auto passes = [&](VerdictKind kind) {
    CheckOptions options;
    options.suite = suite_.root();
    options.require = {kind};
    const Result<SuiteResult> result = check_suite(options);
    return result.ok() && result->passed();
  };
  EXPECT_TRUE(passes(VerdictKind::kExact));
  EXPECT_FALSE(passes(VerdictKind::kBehaviour));
  EXPECT_FALSE(passes(VerdictKind::kImage)) << "there is no picture, so there is nothing to compare";
}

TEST_F(OneCase, ASceneThatCannotBeReadFails) {
  suite_.edit("fall", kSceneFile, "steps = 30", "stepps = 30");
  EXPECT_TRUE(has_problem(suite_.check_one("fall"), "stepps"));
}

TEST(Check, ASuiteWithoutCasesIsAnError) {
  const TemporarySuite suite;
  CheckOptions options;
  options.suite = suite.root();
  EXPECT_FALSE(check_suite(options).ok());
  std::filesystem::create_directory(suite.root() / "cases");
  EXPECT_FALSE(check_suite(options).ok());
}

TEST(Check, AFilterThatMatchesNothingIsAnError) {
  const TemporarySuite suite;
  suite.add("fall");
  CheckOptions options;
  options.suite = suite.root();
  options.selection.names = {"fail"};
  const Result<SuiteResult> named = check_suite(options);
  ASSERT_FALSE(named.ok());
  EXPECT_NE(named.error().message.find("did you mean \"fall\""), std::string::npos) << named.error().message;
  options.selection.names.clear();
  options.selection.category = "energy";
  EXPECT_FALSE(check_suite(options).ok());
  options.selection.category = "stacking";
  EXPECT_TRUE(check_suite(options).ok());
}

TEST(Check, ShardsTogetherAreTheSuiteAndApartHaveNothingInCommon) {
  const TemporarySuite suite;
  for (const char* name : {"a", "b", "c", "d", "e"}) suite.add(name);
  const Result<Suite> open = open_suite(suite.root());
  ASSERT_TRUE(open.ok());
  std::multiset<std::string> seen;
  for (std::size_t k = 1; k <= 3; ++k) {
    Selection selection;
    selection.shard = k;
    selection.shards = 3;
    const Result<std::vector<CaseFolder>> all = select_cases(*open, selection);
    ASSERT_TRUE(all.ok());
    const std::vector<CaseFolder> part = shard_of(*all, selection);
    EXPECT_GE(part.size(), 1U);
    for (const CaseFolder& folder : part) seen.insert(folder.name);
  }
  EXPECT_EQ(seen, (std::multiset<std::string>{"a", "b", "c", "d", "e"}));
}

TEST(Check, TheSuitesOfAnotherEngineAreJudgedByItsLog) {
  const TemporarySuite suite;
  suite.add("fall");
  suite.bless();
  const std::string rules = suite.read(suite.file("fall", kRulesFile));
  std::filesystem::create_directory(suite.root() / "logs");
  suite.write(suite.file("fall", kRulesFile), "[command]\nrun = \"kill -SEGV $$ # {scene} {log}\"\n" + rules);
  const CaseResult killed = suite.check_one("fall");
  EXPECT_TRUE(has_problem(killed, "SIGSEGV")) << testing::PrintToString(killed.problems);
  suite.edit("fall", kRulesFile, "kill -SEGV $$", "echo nothing");
  EXPECT_TRUE(has_problem(suite.check_one("fall"), "wrote no log"));
  std::filesystem::remove(suite.file("fall", kExpectedFile));
  const CaseResult unblessed = suite.check_one("fall");
  EXPECT_NE(unblessed.bless_refused.find("wrote no log"), std::string::npos) << unblessed.bless_refused;
}

TEST(Check, TheLineThatRunsAnotherEngineWorksInAShell) {
  const TemporarySuite place;
  const std::filesystem::path suite = place.root() / "it's a suite";
  const CaseFolder folder{"one two", suite / "cases" / "one two"};
  place.write(folder.file(kSceneFile), "the scene");
  CaseRules rules;
  rules.command = "cat {scene} > {log}";
  const Result<CaseEngine> engine = engine_of_case(folder, rules, suite);
  ASSERT_TRUE(engine.ok());
  const std::string line = engine_line(*engine, folder.name);
  process::Program shell;
  shell.words = {"sh", "-c", line};
  shell.folder = place.root();
  const Result<process::ChildEnd> end = process::run_child(shell);
  ASSERT_TRUE(end.ok() && end->well()) << line;
  EXPECT_EQ(place.read(place.root() / "one two.tumble"), "the scene") << line;
}

}  // namespace
}  // namespace tumble::golden
