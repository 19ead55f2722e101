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
  EXPECT_EQ(shop.run({"record", "w.toml", "--quiet"}).err, "");
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
  EXPECT_TRUE(holds(warnings_of({slow}, thesis + "\ndt = 1.0"), "body 1 moves by 4.905 m in a step of 1.00 s"));
  EXPECT_EQ(warnings_of({fast, slow}), "");
  EXPECT_EQ(warnings_of({"position = [-9, 0, 2]\nvelocity = [50, 0, 0]", slow}, thesis), "");
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
