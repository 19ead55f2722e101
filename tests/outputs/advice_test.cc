// Words that help: suggestions, warnings, estimates, names; and none that contradict one another or come from
// elsewhere.
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "replay/measure/metric_list.h"
#include "tests/outputs/small_table.h"
#include "tests/support/program.h"

namespace tumble::test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Advice, AnOptionThatIsNearlyRightIsNamed) {
  const Workshop shop;
  shop.record_small("a");
  const std::vector<std::pair<Words, std::string>> slips = {
      {{"record", "a.toml", "--second", "3"}, "did you mean --seconds?"},
      {{"record", "a.toml", "--realtme"}, "did you mean --realtime?"},
      {{"measure", "a.tumble", "--requires", "lost<=0"}, "did you mean --require?"},
      {{"diff", "a.tumble", "a.tumble", "--tolerence=position=1"}, "did you mean --tolerance?"}};
  for (const auto& [words, hint] : slips) {
    const Outcome outcome = shop.run(words);
    EXPECT_EQ(outcome.exit, 2);
    EXPECT_TRUE(holds(outcome.err, hint)) << outcome.err;
  }
  EXPECT_FALSE(holds(shop.run({"record", "a.toml", "--frobnicate"}).err, "did you mean"));
  const std::string dash = shop.run({"info", "-x.tumble"}).err;
  EXPECT_TRUE(holds(dash, "found \"-x.tumble\", which is no option; wanted ./-x.tumble for a file of that name"))
      << dash;
}

// A scene of cubes of 1 m.
std::string cubes(const std::vector<std::string>& boxes, const std::string& world) {
  std::string scene = "[world]\nsteps = 2\n" + world + "\n";
  for (const std::string& box : boxes) scene += "[[box]]\nsize = [1, 1, 1]\n" + box + "\n";
  return scene;
}

std::string warnings_of(const std::vector<std::string>& boxes, const std::string& world = "") {
  const Workshop shop;
  shop.write("w.toml", cubes(boxes, world));
  const Outcome outcome = shop.run({"record", "w.toml", "--json"});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["warnings"].empty(), outcome.err.empty()) << outcome.err;
  const Outcome quiet = shop.run({"record", "w.toml", "--quiet"});
  EXPECT_EQ(quiet.err, outcome.err) << "--quiet hides no warning";
  EXPECT_EQ(quiet.out, "");
  return outcome.err;
}

TEST(Advice, AStartThatIsHardlyMeantIsAWarning) {
  EXPECT_TRUE(holds(warnings_of({"position = [0, 0, 2]", "position = [0, 0, 2]"}), "bodies 1 and 2 are in one place"));
  EXPECT_TRUE(holds(warnings_of({"position = [0, 0, 2]", "position = [0.7, 0, 2]"}), "1 and 2 overlap by 0.3 m"));
  EXPECT_TRUE(holds(warnings_of({"position = [0, 0, 0.2]"}), "body 1 is 0.3 m deep in the ground"));
  EXPECT_TRUE(holds(warnings_of({"position = [0, 0, 5]\nfrozen = true"}), "body 1 is frozen in mid-air"));
  EXPECT_TRUE(holds(warnings_of({"position = [0, 0, 5]\nfrozen = true", "position = [0, 0, 6]\nfrozen = true"}),
                    "body 2 is frozen in mid-air"));
  EXPECT_TRUE(holds(warnings_of(std::vector<std::string>(5, "position = [0, 0, 2]")), "and 7 more pairs"));
}

// Method thesis finds collisions where a step ends, and passes a wall at 200 m/s; method layered does not.
TEST(Advice, ABodyThatMayPassThroughOthersIsAWarning) {
  const std::string fast = "position = [-9, 0, 2]\nvelocity = [120, 0, 0]", slow = "position = [9, 0, 2]";
  const std::string thrown = "[[input]]\nstep = 1\nkind = \"throw\"\nposition = [0, 0, 5]\nvelocity = [0, 150, 0]";
  const std::string said = "in a step of 16.7 ms, more than its shortest edge of 1 m, and may pass through others";
  const std::string thesis = "method = \"thesis\"";
  EXPECT_TRUE(holds(warnings_of({fast, slow}, thesis), "body 1 moves by 2.001 m " + said))
      << warnings_of({fast}, thesis);
  EXPECT_TRUE(holds(warnings_of({slow, "position = [9, 4, 2]\n" + thrown}, thesis), "moves by 2.501 m " + said));
  EXPECT_TRUE(holds(warnings_of({fast, slow}, thesis + "\ndt = 1.0"), "body 1 moves by 124.9 m in a step of 1.00 s"));
  EXPECT_EQ(warnings_of({fast, slow}), "");
  EXPECT_EQ(warnings_of({"position = [-9, 0, 2]\nvelocity = [50, 0, 0]", slow}, thesis), "");
}

TEST(Advice, WhatInputsMakeTooFastOrTooCoarseIsAWarning) {
  const std::string box = "position = [-9, 0, 2]", other = "position = [9, 0, 2]", thesis = "method = \"thesis\"";
  const auto with = [&](const std::string& input) {
    return std::vector<std::string>{box, other + "\n[[input]]\nstep = 2\n" + input};
  };
  const std::string set = "kind = \"set_velocity\"\nid = 1\nvelocity = [0, 120, 0]";
  const std::string said = "from step 2 on body 1 moves by 2.001 m in a step of 16.7 ms";
  EXPECT_TRUE(holds(warnings_of(with(set), thesis), said)) << warnings_of(with(set), thesis);
  EXPECT_EQ(warnings_of(with(set)), "");
  EXPECT_TRUE(holds(warnings_of(with("kind = \"set_dt\"\ndt = 1.0")),
                    "from step 2 on gravity moves a body by 4.905 m in a step of 1.00 s with 8 substeps, too far"));
  EXPECT_TRUE(holds(warnings_of(with("kind = \"set_gravity\"\ngravity = [0, 0, -9810]")),
                    "from step 2 on gravity moves a body by 1.363 m in a step of 16.7 ms with 8 substeps, too far"));
  EXPECT_EQ(warnings_of(with("kind = \"set_dt\"\ndt = 0.02")), "");
}

// Five boxes of 0.2 m and more: a tower, or a heap that falls and turns.
std::string five_boxes(bool heap) {
  constexpr const char* kHeap = R"(
[[box]]
size = [0.2, 0.3, 0.25]
position = [0.03, 0.0, 0.4]
axis = [1, 0.3, 0.2]
degrees = 40
[[box]]
size = [0.25, 0.2, 0.35]
position = [-0.05, 0.06, 1.1]
axis = [0.2, 1, 0.1]
degrees = 65
[[box]]
size = [0.3, 0.22, 0.2]
position = [0.04, -0.03, 1.8]
axis = [0.4, -0.5, 1]
degrees = 25
[[box]]
size = [0.2, 0.28, 0.3]
position = [0.0, 0.05, 2.5]
axis = [-1, 0.2, 0.6]
degrees = 80
[[box]]
size = [0.24, 0.2, 0.2]
position = [-0.03, -0.04, 3.2]
axis = [0.1, 0.9, -0.4]
degrees = 55
)";
  return heap ? kHeap : "[[tower]]\ncount = 5\nsize = [0.2, 0.2, 0.2]\n";
}

/// A session of eight seconds as `record` warns of it and `measure` finds it.
struct Judged {
  std::vector<std::string> warnings;
  int lost = 0;
};
Judged judged(const Workshop& shop, double dt, const std::vector<std::string>& settings) {
  Words words = {"record", "w.toml", "--json", "--seconds", "8", "--set", "world.dt=" + std::to_string(dt)};
  for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
  const Outcome recorded = shop.run(words);
  EXPECT_EQ(recorded.exit, 0) << recorded.err;
  const Outcome measured = shop.run({"measure", "w.tumble", "--json"});
  return {Json::parse(recorded.out)["warnings"].get<std::vector<std::string>>(),
          Json::parse(measured.out)["stacking"]["lost"].get<int>()};
}

// Heaps of method layered and towers of method thesis lose bodies at such steps, and none as they are told to be.
TEST(Advice, AStepThatIsTooLongForGravityIsAWarning) {
  const Workshop shop;
  for (const bool heap : {true, false}) {
    shop.write("w.toml", five_boxes(heap));
    const std::string method = heap ? "world.method=\"layered\"" : "world.method=\"thesis\"";
    const Judged bad = judged(shop, 1, {method});
    ASSERT_EQ(bad.warnings.size(), 1U);
    EXPECT_TRUE(
        bad.warnings[0].starts_with("gravity moves a body by 4.905 m in a step of 1.00 s with 8 substeps, too far "
                                    "for body 1 with its shortest edge of 0.2 m: "))
        << bad.warnings[0];
    EXPECT_GT(bad.lost, heap ? 0 : 2);
    EXPECT_EQ(bad.warnings[0].ends_with("take a dt of at most 0.2 s or substeps = 197"), heap) << bad.warnings[0];
    EXPECT_EQ(bad.warnings[0].ends_with("take a dt of at most 0.2 s"), !heap) << bad.warnings[0];
    const Judged good = judged(shop, 0.2, {method}), fine = judged(shop, 1, {method, "world.substeps=197"});
    EXPECT_TRUE(good.warnings.empty());
    EXPECT_EQ(good.lost, 0);
    EXPECT_EQ(fine.warnings.empty(), heap) << "method thesis misses what falls past others in a step";
    EXPECT_EQ(fine.lost, 0);
  }
}

TEST(Advice, AStepWithFewSubstepsIsTooLongSooner) {
  const Workshop shop;
  shop.write("w.toml", five_boxes(false));
  const Judged bad = judged(shop, 0.1, {"world.method=\"thesis\"", "world.substeps=1"});
  ASSERT_EQ(bad.warnings.size(), 1U);
  EXPECT_TRUE(holds(bad.warnings[0], "by 0.04905 m in a step of 0.10 s with 1 substep,")) << bad.warnings[0];
  EXPECT_TRUE(bad.warnings[0].ends_with("take a dt of at most 0.025 s or substeps = 4")) << bad.warnings[0];
  EXPECT_GT(bad.lost, 2);
  const Judged good = judged(shop, 0.1, {"world.method=\"thesis\"", "world.substeps=4"});
  EXPECT_TRUE(good.warnings.empty());
  EXPECT_EQ(good.lost, 0);
  EXPECT_TRUE(judged(shop, 1, {"world.gravity=[0, 0, 0]"}).warnings.empty());
}

// Nothing gains speed from such a start; what is pushed up gains the energy of its height.
TEST(Advice, ABoxInABoxIsNamedByBothMethods) {
  const std::vector<std::string> boxes = {"position = [0, 0, 0.5]", "position = [0.2, 0.1, 0.6]"};
  for (const char* method : {"method = \"thesis\"", "method = \"layered\""}) {
    EXPECT_TRUE(
        holds(warnings_of(boxes, method), "bodies 1 and 2 overlap by 0.8 m at the start and will be pushed apart"))
        << warnings_of(boxes, method);
  }
}

TEST(Advice, AStackThatStandsIsNone) {
  EXPECT_EQ(warnings_of({"position = [0, 0, 0.5]\nfrozen = true", "position = [0, 0, 1.5]\nfrozen = true"}), "");
  EXPECT_EQ(warnings_of({"position = [0, 0, 3]\nstatic = true", "position = [0, 0, 4]\nfrozen = true"}), "");
  EXPECT_EQ(warnings_of({"position = [0, 0, 5]", "position = [0.95, 0, 5]"}), "") << "a little overlap";
}

TEST(Advice, MeasurePrintsTheNamesThatRequireTakes) {
  const Workshop shop;
  shop.record_small("a");
  std::istringstream lines(shop.run({"measure", "a.tumble"}).out);
  std::string all;
  for (std::string line; std::getline(lines, line);) all += line + "\n";
  for (const replay::MetricRow& metric : replay::metric_list()) {
    const std::size_t label = all.find("  " + std::string(metric.label) + "  ");
    ASSERT_NE(label, std::string::npos) << metric.label;
    const std::string row = all.substr(label, all.find('\n', label) - label);
    EXPECT_TRUE(row.ends_with("  " + std::string(metric.name))) << row;
  }
}

TEST(Advice, RealTimeSaysWhetherItFollowedTheClock) {
  const Workshop shop;
  shop.write("a.toml", kSmallScene);
  const auto record = [&](const std::string& longest) {
    return shop.run({"record", "a.toml", "--realtime", "--set", "world.dt=0.004", "--longest-step", longest});
  };
  const Outcome behind = record("0.001");  // shorter than a frame: each step is cut short
  EXPECT_TRUE(holds(behind.out, " behind: 40 steps reached the longest step allowed")) << behind.out;
  const Outcome followed = record("1");
  EXPECT_TRUE(holds(followed.out, "clock       followed")) << followed.out;
  EXPECT_FALSE(holds(followed.out, "behind")) << followed.out;
  for (const Outcome& outcome : {behind, followed})
    EXPECT_TRUE(holds(outcome.out, " computed in time, ")) << outcome.out;
}

TEST(Advice, WarningsOfGnuplotStayWithin) {
  const Workshop shop;
  shop.write("t.csv", kSmallTable);
  ASSERT_EQ(shop.run({"import", "t.csv"}).exit, 0);
  const Outcome outcome = shop.run({"measure", "t.tumble", "--plot", "t.svg"});  // nothing moves: axes without extent
  EXPECT_EQ(outcome.exit, 0);
  EXPECT_EQ(outcome.err, "");
}

// What the program writes to a terminal.
std::string on_terminal(const Workshop& shop, const Words& arguments) {
  int terminal = -1;
  const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) {
    if (::chdir(shop.path("").c_str()) != 0) ::_exit(127);
    Words words = {TUMBLE_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    ::execv(argv[0], argv.data());
    ::_exit(127);
  }
  std::string text;
  std::array<char, 4096> block = {};
  for (ssize_t got = 0; (got = ::read(terminal, block.data(), block.size())) > 0;) {
    text.append(block.data(), static_cast<std::size_t>(got));
  }
  ::close(terminal);
  ::waitpid(child, nullptr, 0);
  return text;
}

TEST(Advice, AProgressBarEstimatesTheTimeLeft) {
  const Workshop shop;
  shop.write("a.toml", kSmallScene);
  const std::string text = on_terminal(shop, {"record", "a.toml", "--realtime", "--set", "world.steps=60"});
  EXPECT_TRUE(holds(text, "step ")) << text;
  EXPECT_TRUE(holds(text, ", about 1 s left")) << text;
}

}  // namespace
}  // namespace tumble::test
