// A question that judges nothing is never answered "passed": shards, bounds, bodies and steps that are not there.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/program.h"

namespace tumble::test {
namespace {

using nlohmann::ordered_json;

constexpr const char* kRules = "[[metric]]\nname = \"drift_max\"\nmax = 100.0\nwhy = \"they fall\"\n";

class EmptyQuestion : public testing::Test {
 protected:
  void SetUp() override {
    add("one", kRules);
    add("two", kRules);
    ASSERT_EQ(bless().exit, 0);
  }
  void add(const std::string& name, const std::string& rules) const {
    shop_.write("s/cases/" + name + "/scene.toml", kSmallScene);
    shop_.write("s/cases/" + name + "/metrics.toml", rules);
  }
  [[nodiscard]] Outcome bless() const { return shop_.run({"bless", "--all", "--suite", "s", "--reason", "a test"}); }
  [[nodiscard]] Outcome check(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"check", "--suite", "s", "--report", "r"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return shop_.run(arguments);
  }
  Workshop shop_;
};

TEST_F(EmptyQuestion, AShardWithoutCasesSaysSo) {
  const Outcome outcome = check({"--shard", "4/5"});
  EXPECT_EQ(outcome.exit, 0) << "a shard without a case is no failure";
  EXPECT_NE(outcome.out.find("nothing was judged: shard 4 of 5 has no case, of 2 in all"), std::string::npos)
      << outcome.out;
  EXPECT_EQ(outcome.out.find("passed"), std::string::npos) << outcome.out;
  const ordered_json report = ordered_json::parse(shop_.read("r/report.json"));
  EXPECT_EQ(report["is_empty_shard"], true);
  EXPECT_EQ(report["judged_cases"], 0);
  EXPECT_EQ(ordered_json::parse(check({"--shard", "1/5", "--json"}).out)["is_empty_shard"], false);
  EXPECT_EQ(check({"--shard", "4/5"}).exit, 0);
  EXPECT_NE(shop_.read("r/junit.xml").find("<skipped message=\"nothing was judged"), std::string::npos);
  EXPECT_EQ(shop_.read("r/index.html").find("✓ nothing"), std::string::npos);
}

TEST_F(EmptyQuestion, BoundsThatHoldForEverySessionAreErrors) {
  shop_.record_small("session");
  for (const char* bound : {"lost>=0", "lost>-1", "frozen_fraction<=1", "lost<=inf", "drift_max>=-inf",
                            "drift_max<=1e300", "tilt_max<=180"}) {
    const Outcome outcome = shop_.run({"measure", "session.tumble", "--require", bound});
    EXPECT_EQ(outcome.exit, 2) << bound << outcome.out;
  }
  EXPECT_EQ(shop_.run({"measure", "session.tumble", "--require", "lost<=0"}).exit, 0);
  for (const char* rules : {"[[metric]]\nname = \"lost\"\nmin = 0\nwhy = \"w\"\n",
                            "[[metric]]\nname = \"drift_max\"\nmax = 1e300\nwhy = \"w\"\n",
                            "[[metric]]\nname = \"frozen_fraction\"\nmax = 1.0\nwhy = \"w\"\n",
                            "[[metric]]\nname = \"lost\"\nmax = 0\nwhy = \"w\"\n[[picture]]\nstep = 3\nwidth = 64\n"
                            "height = 64\nfar_off_max = 4096\nwhy = \"w\"\n"}) {
    shop_.write("s/cases/two/metrics.toml", rules);
    const Outcome outcome = check({"two"});
    EXPECT_EQ(outcome.exit, 1) << rules;
    EXPECT_NE(outcome.out.find("holds for every"), std::string::npos) << outcome.out;
  }
}

TEST_F(EmptyQuestion, AnImageVerdictWithoutAPictureSaysSo) {
  const Outcome outcome = check({"one", "--require", "image"});
  EXPECT_EQ(outcome.exit, 1) << outcome.out;
  EXPECT_NE(outcome.out.find("no picture to judge, and an image verdict is required"), std::string::npos)
      << outcome.out;
}

TEST_F(EmptyQuestion, RulesThatCannotBeReadCondemnNoFile) {
  shop_.write("s/cases/one/mine.txt", "an input");
  EXPECT_NE(check({"one"}).out.find("unreferenced: nothing reads mine.txt"), std::string::npos);
  shop_.write("s/cases/one/metrics.toml", "[[metric]]\nname = \"drift_max\"\nmax = inf\nwhy = \"w\"\n");
  const Outcome outcome = check({"one"});
  EXPECT_EQ(outcome.exit, 1);
  EXPECT_EQ(outcome.out.find("unreferenced"), std::string::npos) << outcome.out;
}

TEST_F(EmptyQuestion, ASessionWithoutAStepOrABodyToMeasureIsAnError) {
  shop_.record_small("session");
  const Outcome last = shop_.run({"measure", "session.tumble", "--from-step", "40", "--require", "drift_max<=0"});
  EXPECT_EQ(last.exit, 2) << last.out;
  EXPECT_NE(last.err.find("no step to judge"), std::string::npos) << last.err;
  shop_.write("still.toml", "[world]\nsteps = 10\n[[box]]\nposition = [0.0, 0.0, 0.5]\nstatic = true\n");
  ASSERT_EQ(shop_.run({"record", "still.toml", "-o", "still.tumble", "--quiet"}).exit, 0);
  const Outcome still = shop_.run({"measure", "still.tumble", "--require", "lost<=0"});
  EXPECT_EQ(still.exit, 2) << still.out;
  EXPECT_NE(still.err.find("no body to judge"), std::string::npos) << still.err;
  EXPECT_EQ(shop_.run({"measure", "still.tumble"}).exit, 0) << "to look at it is no question";
}

TEST_F(EmptyQuestion, MetricsThatAllReadNullJudgeNothing) {
  add("null", "[[metric]]\nname = \"column_spread\"\nmax = 0\nmay_be_null = true\nwhy = \"there is no grid\"\n");
  const Outcome refused = shop_.run({"bless", "null", "--suite", "s", "--reason", "a test"});
  EXPECT_EQ(refused.exit, 2);
  EXPECT_NE(refused.err.find("every metric reads null"), std::string::npos) << refused.err;
  const Outcome outcome = check({"null", "--require", "behaviour"});
  EXPECT_EQ(outcome.exit, 1);
  EXPECT_NE(outcome.out.find("nothing was judged: every metric reads null"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace tumble::test
