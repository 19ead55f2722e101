// check and bless as a person or CI runs them: exit statuses, what is printed, the files they leave.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "tests/support/program.h"

namespace tumble::test {
namespace {

using nlohmann::ordered_json;

constexpr const char* kRules = R"([[metric]]
name = "drift_max"
max = 100.0
why = "they fall and topple"
)";

/// A workshop with a suite "s" of small cases, blessed.
class SmallSuite : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"one", "two", "three"}) add(name);
    const Outcome outcome = shop_.run({"bless", "--all", "--suite", "s", "--reason", "a test"});
    ASSERT_EQ(outcome.exit, 0) << outcome.err;
  }
  void add(const std::string& name) const {
    shop_.write("s/cases/" + name + "/scene.toml", kSmallScene);
    shop_.write("s/cases/" + name + "/metrics.toml", kRules);
  }
  [[nodiscard]] Outcome check(std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {"check", "--suite", "s", "--report", "r"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return shop_.run(arguments);
  }
  Workshop shop_;
};

TEST_F(SmallSuite, PassesWithStatusZeroAndLeavesAReport) {
  const ordered_json printed = ordered_json::parse(check({"--json"}).out);
  EXPECT_EQ(ordered_json::parse(shop_.read("r/report.json")), printed);
  const Outcome outcome = check();
  EXPECT_EQ(outcome.exit, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("3 cases passed"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("same bits, 1 metric unmoved"), std::string::npos) << outcome.out;
  const ordered_json report = ordered_json::parse(shop_.read("r/report.json"));
  EXPECT_EQ(report["passed"], true);
  EXPECT_EQ(report["canaries_caught"], true);
  EXPECT_NE(shop_.read("r/junit.xml").find("failures=\"0\""), std::string::npos);
  const std::string page = shop_.read("r/index.html");
  EXPECT_NE(page.find("3 cases passed"), std::string::npos);
  for (const char* outside : {"http:", "https:", "src=", "<script", "@import", "url("}) {
    EXPECT_EQ(page.find(outside), std::string::npos) << "the page must need nothing else: " << outside;
  }
}

// A service starts without HOME and with another PATH; the folder for temporary files may be called anything.
TEST_F(SmallSuite, CatchesItsCanariesInAnySurroundings) {
  for (const char* before : {"unset HOME; ", "PATH=/nowhere; export PATH; ",
                             "mkdir -p \"it's one\"; TMPDIR=\"$PWD/it's one\"; export TMPDIR; "}) {
    const Outcome outcome = shop_.run_after(before, {"check", "--suite", "s", "--report", "r"});
    EXPECT_EQ(outcome.exit, 0) << before << outcome.out << outcome.err;
  }
}

TEST_F(SmallSuite, AnnotatesFailuresForCiServicesInOneLineEach) {
  EXPECT_EQ(check({"--annotate", "github"}).out.find("::error"), std::string::npos);
  EXPECT_EQ(check({"--annotate", "gitlab"}).exit, 0);
  EXPECT_EQ(ordered_json::parse(shop_.read("r/gl-code-quality-report.json")), ordered_json::array());

  std::string scene = shop_.read("s/cases/two/scene.toml");
  shop_.write("s/cases/two/scene.toml", scene.replace(scene.find("[0.0, 0.0, 0.7]"), 15, "[0.0, 0.0, 0.8]"));
  const std::string printed = check({"--annotate", "github"}).out;
  const std::size_t begin = printed.find("::error file=s/cases/two/scene.toml,line=1,title=two::two: ");
  ASSERT_NE(begin, std::string::npos) << printed;
  const std::string line = printed.substr(begin, printed.find('\n', begin) - begin);
  EXPECT_NE(line.find("first difference: step 0, phase start"), std::string::npos) << line;
  EXPECT_EQ(printed.find("::error", begin + 1), std::string::npos) << "one failure, one line";
  EXPECT_TRUE(ordered_json::accept(check({"--annotate", "github", "--json"}).out)) << "nothing but JSON";

  EXPECT_EQ(check({"--annotate", "gitlab"}).exit, 1);
  const ordered_json findings = ordered_json::parse(shop_.read("r/gl-code-quality-report.json"));
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0]["location"]["path"], "s/cases/two/scene.toml");
  EXPECT_EQ(findings[0]["location"]["lines"]["begin"], 1);
  EXPECT_EQ(findings[0]["fingerprint"].get<std::string>().size(), 32U);
  EXPECT_NE(findings[0]["description"].get<std::string>().find("first difference: step 0, phase start"),
            std::string::npos);

  EXPECT_EQ(check().exit, 1);
  EXPECT_TRUE(shop_.names_with("gl-code-quality").empty()) << "of an earlier check";
  EXPECT_EQ(check({"--annotate", "elsewhere"}).exit, 2);
}

TEST_F(SmallSuite, AFailureIsStatusOneAndNamesVerdictMarginAndCommands) {
  std::string rules = shop_.read("s/cases/two/metrics.toml");
  rules.replace(rules.find("max = 100.0"), 11, "max = 1e-9");
  shop_.write("s/cases/two/metrics.toml", rules);
  const Outcome outcome = check({"--junit", "elsewhere.xml"});
  EXPECT_EQ(outcome.exit, 1);
  for (const char* words : {"FAILED  two", "1 of 1 metric failed: drift_max ", "above the bound by",
                            "why: they fall and topple", "tumble record s/cases/two/scene.toml -o two.tumble",
                            "bless would refuse it: drift_max is ", "1 of 3 cases failed"}) {
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words << "\n" << outcome.out;
  }
  EXPECT_NE(shop_.read("elsewhere.xml").find("failures=\"1\""), std::string::npos);
  const std::string page = shop_.read("r/index.html");
  for (const char* words :
       {"✕ two", "behaviour failed", "exact passed", "above the bound by", "bless would refuse it"}) {
    EXPECT_NE(page.find(words), std::string::npos) << words;
  }
  EXPECT_LT(page.find("✕ two"), page.find("✓ one")) << "failed cases come first";
  EXPECT_EQ(shop_.run({"replay", "r/cases/two/actual.tumble"}).exit, 0);
  EXPECT_EQ(check({"--require", "exact"}).exit, 0);
}

TEST_F(SmallSuite, ACaseThatDiesIsNamedWithItsSignal) {
  shop_.write("s/cases/two/metrics.toml", std::string("[command]\nrun = \"kill -ABRT $$ # {scene} {log}\"\n") + kRules);
  const Outcome outcome = check();
  EXPECT_EQ(outcome.exit, 1);
  EXPECT_NE(outcome.out.find("SIGABRT"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("1 of 3 cases failed"), std::string::npos) << outcome.out;
}

TEST_F(SmallSuite, ACaseThatHangsIsEnded) {
  shop_.write("s/cases/two/metrics.toml", std::string("[command]\nrun = \"sleep 100 # {scene} {log}\"\n") + kRules);
  const Outcome outcome = check({"--timeout", "0.5"});
  EXPECT_EQ(outcome.exit, 1);
  EXPECT_NE(outcome.out.find("took longer than"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("&& sleep 100"), std::string::npos) << "not this program: " << outcome.out;
  const std::filesystem::path temporary = shop_.path("tmp");
  std::filesystem::create_directory(temporary);
  EXPECT_EQ(
      shop_.run_after("export TMPDIR='" + temporary.string() + "'; ", {"check", "--suite", "s", "--timeout", "0.5"})
          .exit,
      1);
  EXPECT_TRUE(std::filesystem::is_empty(temporary)) << "an engine that is ended cannot remove its own files";
}

TEST_F(SmallSuite, AnotherEngineIsJudgedByTheLogItWrites) {
  const std::string run = std::string("[command]\nrun = \"") + TUMBLE_PROGRAM + " record {scene} -o {log} --quiet";
  shop_.write("s/cases/two/metrics.toml", run + "\"\n" + kRules);
  ASSERT_EQ(shop_.run({"bless", "two", "--suite", "s", "--reason", "its own engine"}).exit, 0);
  EXPECT_EQ(check().exit, 0);
  std::string rules = shop_.read("s/cases/two/metrics.toml");
  rules.replace(rules.find("--quiet"), 7, "--quiet --set 'world.gravity=[0, 0, -9.8]'");
  shop_.write("s/cases/two/metrics.toml", rules);
  const Outcome outcome = check();
  EXPECT_EQ(outcome.exit, 1);
  EXPECT_NE(outcome.out.find("bits moved"), std::string::npos) << outcome.out;
}

// "Same" is said of bits alone: metrics within their bounds may have moved, and the words say which and by how much.
TEST_F(SmallSuite, ACaseWithinItsBoundsIsToldFromOneThatIsUnchanged) {
  const std::string run = std::string("[command]\nrun = \"") + TUMBLE_PROGRAM + " record {scene} -o {log} --quiet";
  shop_.write("s/cases/two/metrics.toml", run + "\"\n" + kRules);
  ASSERT_EQ(shop_.run({"bless", "two", "--suite", "s", "--reason", "its own engine"}).exit, 0);
  std::string rules = shop_.read("s/cases/two/metrics.toml");
  rules.replace(rules.find("--quiet"), 7, "--quiet --set 'world.gravity=[1.5, 0, -9.8]'");
  shop_.write("s/cases/two/metrics.toml", rules);
  const Outcome outcome = check({"--require", "behaviour"});
  EXPECT_EQ(outcome.exit, 0) << outcome.out;
  for (const char* words :
       {" apart (body ", "bits moved from step ", "1 of 1 metric moved within bounds, most: drift_max ", " → ",
        "3 cases passed: 2 unchanged, 1 moved within bounds"}) {
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words << "\n" << outcome.out;
  }
  EXPECT_EQ(outcome.out.find("behaviour same"), std::string::npos) << outcome.out;
  const ordered_json report = ordered_json::parse(shop_.read("r/report.json"));
  EXPECT_EQ(report["changes"]["within_bounds"], 1);
  EXPECT_EQ(report["changes"]["unchanged"], 2);
  EXPECT_EQ(report["cases"][0]["change"], "unchanged");
  const ordered_json& two = report["cases"][2];
  EXPECT_EQ(two["change"], "within_bounds");
  EXPECT_GT(two["magnitude"]["apart"]["metres"].get<double>(), 0.1);
  EXPECT_EQ(two["magnitude"]["most"]["name"], "drift_max");
  EXPECT_EQ(two["magnitude"]["metrics_moved"], 1);
  EXPECT_NE(shop_.read("r/junit.xml").find("<system-out>moved within bounds: "), std::string::npos);
  const std::string page = shop_.read("r/index.html");
  EXPECT_NE(page.find("data-verdict=\"within_bounds\""), std::string::npos);
  EXPECT_NE(page.find("1 of 1 metric moved within bounds"), std::string::npos);
}

TEST_F(SmallSuite, ShardsCoverTheSuiteOnce) {
  std::multiset<std::string> seen;
  for (const char* shard : {"1/2", "2/2"}) {
    const Outcome outcome = check({"--shard", shard, "--json"});
    EXPECT_EQ(outcome.exit, 0);
    const ordered_json report = ordered_json::parse(outcome.out);
    for (const auto& one : report["cases"]) seen.insert(one["name"].get<std::string>());
  }
  EXPECT_EQ(seen, (std::multiset<std::string>{"one", "two", "three"}));
}

TEST_F(SmallSuite, BadUsageIsStatusTwo) {
  for (const std::vector<std::string>& more : {std::vector<std::string>{"four"},
                                               {"--shard", "3/2"},
                                               {"--shard", "0/2"},
                                               {"--shard", "x"},
                                               {"--require", "luck"},
                                               {"--category", "nothing"},
                                               {"--jobs", "0"}}) {
    EXPECT_EQ(check(more).exit, 2) << more.front();
  }
  EXPECT_EQ(shop_.run({"check", "--suite", "nowhere"}).exit, 2);
  EXPECT_EQ(shop_.run({"bless", "one", "--suite", "s"}).exit, 2) << "a reason is required";
  EXPECT_EQ(shop_.run({"bless", "--suite", "s", "--reason", "x"}).exit, 2) << "which cases?";
  EXPECT_EQ(shop_.run({"bless", "one", "--all", "--suite", "s", "--reason", "x"}).exit, 2);
  EXPECT_EQ(shop_.run({"bless", "new", "--from", "none.tumble", "--suite", "s", "--reason", "x"}).exit, 2);
}

TEST_F(SmallSuite, BlessPrintsValuesInAsManyDigitsAsTellThemApart) {
  std::string rules = shop_.read("s/cases/one/metrics.toml");
  const std::size_t at = rules.find("value = ") + 8;
  const double value = std::stod(rules.substr(at));
  rules.replace(at, rules.find('\n', at) - at, std::to_string(value + 2e-6));
  shop_.write("s/cases/one/metrics.toml", rules);
  const Outcome outcome = shop_.run({"bless", "one", "--suite", "s", "--reason", "x", "--dry-run"});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  const std::size_t arrow = outcome.out.find(" → ");
  ASSERT_NE(arrow, std::string::npos) << outcome.out;
  const double before = std::stod(outcome.out.substr(outcome.out.find("drift_max ") + 10));
  EXPECT_NE(before, std::stod(outcome.out.substr(arrow + std::string(" → ").size()))) << outcome.out;
}

TEST_F(SmallSuite, ABodyThatTheSessionNeverHasFailsTheCase) {
  const std::string rules = shop_.read("s/cases/one/metrics.toml");
  const std::size_t at = rules.find("name = \"drift_max\"\n");
  ASSERT_NE(at, std::string::npos) << rules;
  shop_.write("s/cases/one/metrics.toml", std::string(rules).insert(at, "bodies = [1, 7777]\n"));
  const Outcome outcome = check({"one"});
  EXPECT_EQ(outcome.exit, 1) << outcome.out;
  EXPECT_NE(outcome.out.find("drift_max: bodies: found no body 7777"), std::string::npos) << outcome.out;
}

TEST_F(SmallSuite, ACategoryThatOtherCasesHaveIsNotCalledUnknown) {
  std::string scene = kSmallScene;
  scene.replace(scene.find("\"session\""), 9, "\"small\"");
  shop_.write("s/cases/two/scene.toml", scene);
  const Outcome outcome = check({"one", "--category", "small"});
  EXPECT_EQ(outcome.exit, 2);
  EXPECT_NE(outcome.err.find("\"small\" among those named: one"), std::string::npos) << outcome.err;
}

TEST_F(SmallSuite, BlessFromALogSaysWhyNoCaseCanBeMadeOfIt) {
  const auto bless = [&](const std::vector<std::string>& how) {
    std::vector<std::string> record = {"record", "-o", "l.tumble", "--quiet"};
    record.insert(record.end(), how.begin(), how.end());
    EXPECT_EQ(shop_.run(record).exit, 0);
    return shop_.run({"bless", "new", "--from", "l.tumble", "--suite", "s", "--reason", "x"});
  };
  shop_.write("a.toml", kSmallScene);
  ASSERT_EQ(shop_.run({"record", "a.toml", "-o", "a.tumble", "--quiet"}).exit, 0);
  for (const auto& [how, why] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"--from", "a.tumble:20"}, "goes on from step 20 of a.tumble"},
           {{"a.toml", "--shift", "8,0"}, "its scene was transformed when it was recorded (shift 8,0)"},
           {{"a.toml", "--realtime", "--steps", "6"}, "inputs that its scene does not have"},
           {{"a.toml", "--steps", "3"}, "no case can be made of the scene that it holds"}}) {
    const Outcome outcome = bless(how);
    EXPECT_EQ(outcome.exit, 2) << outcome.out;
    EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("with this build first"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("s/cases/new"), std::string::npos) << outcome.err;
  }
  const Outcome made = bless({"a.toml"});
  EXPECT_EQ(made.exit, 0) << made.err;
  EXPECT_EQ(made.out.find("()"), std::string::npos) << made.out;
}

TEST_F(SmallSuite, BlessFromALogMakesACaseThatPasses) {
  shop_.record_small("session", {"--set", "box.2.position=[0.1, 0.2, 2.5]"});
  const Outcome outcome =
      shop_.run({"bless", "found", "--from", "session.tumble", "--suite", "s", "--reason", "seen", "--json"});
  ASSERT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_EQ(ordered_json::parse(outcome.out)["blessed"][0]["name"], "found");
  EXPECT_EQ(check({"found"}).exit, 0) << check({"found"}).out;
  EXPECT_NE(shop_.read("s/HISTORY.md").find("seen"), std::string::npos);
}

}  // namespace
}  // namespace tumble::test
