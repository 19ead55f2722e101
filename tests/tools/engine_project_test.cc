// tumble.toml: a user's engine is built and run by replay, check and bisect, and every mistake in the file is named.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/program.h"
#include "tests/tools/json_output.h"
#include "tests/tools/toy.h"

namespace tumble::test {
namespace {

using nlohmann::ordered_json;

void write_project(const Workshop& shop, const std::string& run, const std::string& more = "") {
  shop.write("tumble.toml", "[engine]\nrun = '" + run + "'\n" + more);
}

TEST(EngineProject, ReplaySaysSameOfAnEngineThatRepeatsItself) {
  const Workshop shop;
  record_toy(shop, "a.tumble");
  write_project(shop, kToy);
  std::system(("mkdir -p '" + shop.path("deep/er") + "'").c_str());
  const Outcome same = shop.run({"replay", "a.tumble"});
  EXPECT_EQ(same.exit, 0) << same.out << same.err;
  EXPECT_TRUE(says(same.out, "same: 40 steps computed again by toy 1 with the log's inputs")) << same.out;
  EXPECT_TRUE(says(same.out, "inputs")) << "what was compared";
  const Outcome below = shop.run_after("cd deep/er; ", {"replay", "../../a.tumble", "--json"});
  EXPECT_EQ(below.exit, 0) << below.err;
  EXPECT_EQ(parsed(below)["identical"], true);
  EXPECT_FALSE(parsed(below)["compared"].empty());
}

TEST(EngineProject, ReplayNamesTheFirstFieldOfAChangedEngine) {
  const Workshop shop;
  record_toy(shop, "a.tumble");
  write_project(shop, kToy + " --fault 10");
  const Outcome text = shop.run({"replay", "a.tumble"});
  EXPECT_EQ(text.exit, 1) << text.err;
  EXPECT_TRUE(says(text.out, "different: the first of 40 steps that differs is step 10")) << text.out;
  const Outcome changed = shop.run({"replay", "a.tumble", "--json", "-o", "again.tumble"});
  EXPECT_EQ(changed.exit, 1);
  const ordered_json first = parsed(changed)["first"];
  EXPECT_EQ(first["body"], 1) << "the friction of its contact moves the lower body too";
  EXPECT_EQ(first["field"], "position.x");
  EXPECT_EQ(shop.run({"diff", "a.tumble", "again.tumble"}).exit, 1) << "-o keeps the new session";
  const Outcome without = shop.run({"replay", "a.tumble", "-o", "a.tumble"});
  EXPECT_EQ(without.exit, 2) << "the log itself is no output";
}

TEST(EngineProject, ReplayGivesTheInputsOfTheLog) {
  const Workshop shop;
  record_toy(shop, "a.tumble");
  write_project(shop, std::string(TUMBLE_TOY_ENGINE) + " --log {log}");
  const Outcome without = shop.run({"replay", "a.tumble", "--json"});
  EXPECT_EQ(without.exit, 1) << without.err;
  EXPECT_EQ(parsed(without)["first"]["step"], 10);
  EXPECT_EQ(parsed(without)["first"]["field"], "inputs");
}

TEST(EngineProject, ReplayReadsTheTableOfAnEngine) {
  const Workshop shop;
  record_toy(shop, "a.csv", "--table");
  ASSERT_EQ(shop.run({"import", "a.csv"}).exit, 0);
  write_project(shop, kToy + " --table --push 10:2:3");  // a table holds no pushes
  const Outcome same = shop.run({"replay", "a.tumble"});
  EXPECT_EQ(same.exit, 0) << same.out << same.err;
  write_project(shop, kToy + " --table --push 10:2:3 --fault 1");
  EXPECT_EQ(shop.run({"replay", "a.tumble"}).exit, 1);
}

TEST(EngineProject, AShellOnlyWhereItIsAskedFor) {
  const Workshop shop;
  record_toy(shop, "a.tumble");
  const std::string line = "cat {inputs} > inputs.txt; " + kToy;
  write_project(shop, line, "shell = true\nbuild = ['echo built >> built.txt']\n");
  EXPECT_EQ(shop.run({"replay", "a.tumble"}).exit, 0);
  EXPECT_TRUE(
      says(shop.read("inputs.txt"), R"({"step":10,"kind":"push","id":2,"impulse":[3.0,0.0,0.0],"at_centre":true})"))
      << shop.read("inputs.txt");
  EXPECT_EQ(shop.read("built.txt"), "built\n");
  EXPECT_EQ(shop.run({"replay", "a.tumble", "--no-build"}).exit, 0);
  EXPECT_EQ(shop.read("built.txt"), "built\n");
  write_project(shop, line);
  EXPECT_EQ(shop.run({"replay", "a.tumble"}).exit, 4) << "no program is called cat with such files";
}

TEST(EngineProject, MistakesAreNamedWithFileLineAndKey) {
  const Workshop shop;
  record_toy(shop, "a.tumble");
  const auto fails = [&](const std::string& toml, const std::string& words, int exit = 2) {
    shop.write("tumble.toml", toml);
    const Outcome outcome = shop.run({"replay", "a.tumble"});
    EXPECT_EQ(outcome.exit, exit) << toml << outcome.out;
    EXPECT_TRUE(says(outcome.err, words)) << outcome.err;
  };
  fails("[engine]\nrun = 'x'\n",
        "tumble.toml:2:7: [engine] key \"run\": found \"x\", wanted a command line with {log}");
  fails("[engine]\nrum = 'x {log}'\n", "tumble.toml:2:");
  fails("[engine]\nrun = 'x {log}'\nbuild = 'a \"b'\n", "tumble.toml:3:9: [engine] key \"build\": found");
  fails("[engine]\nrun = 'x {log}'\nbuild = []\n", "or no key where nothing is to be built");
  fails("[engine]\nrun = 'x {log}'\nshell = 1\n", "tumble.toml:3:9: [engine] key \"shell\": found 1, wanted");
  fails("[engin]\nrun = 'x {log}'\n", "engin");
  fails("[engine]\nrun = '\n", "tumble.toml:2:");
  fails("[engine]\nrun = 'no_such_program_at_all {log}'\n", "no_such_program_at_all", 4);
  fails("[engine]\nrun = 'sh -c \"echo too bad; exit 3\" {log}'\n", "ended with status 3; it printed: too bad", 4);
  fails("[engine]\nrun = 'true {log}'\n", "wrote no log", 4);
  fails("[engine]\nrun = 'true {scene} {log}'\n", "run: found {scene}, and the log holds no scene text");
  fails("[engine]\nrun = 'true {log}'\nbuild = 'false'\n", "the build command \"false\" ended with status 1", 4);
  fails("[engine]\nrun = 'sleep 60 {log}'\ntimeout = 0.2\n", "", 4);
  std::system(("rm '" + shop.path("tumble.toml") + "'").c_str());
  const Outcome none = shop.run({"replay", "a.tumble"});
  EXPECT_EQ(none.exit, 2);
  EXPECT_TRUE(says(none.err, "only compared")) << none.err;
  EXPECT_TRUE(says(none.err, "tumble.toml")) << none.err;
}

#ifdef TUMBLE_PEER_BULLET
TEST(EngineProject, ReplayOfBulletSaysSameAndNamesTheFieldOfAChangedParameter) {
  const Workshop shop;
  shop.write("level.toml", kSmallScene);
  const std::string run = std::string(TUMBLE_PEER_BULLET) + " {scene} --log {log}";
  write_project(shop, run, "scene = 'level.toml'\n");
  ASSERT_EQ(std::system(("'" TUMBLE_PEER_BULLET "' '" + shop.path("level.toml") + "' --log '" + shop.path("a.tumble") +
                         "' >/dev/null")
                            .c_str()),
            0);
  const Outcome same = shop.run({"replay", "a.tumble"});
  EXPECT_EQ(same.exit, 0) << same.out << same.err;
  EXPECT_TRUE(says(same.out, "same: 40 steps computed again by Bullet")) << same.out;
  write_project(shop, run + " --set world.gravity=[0,0,-9.8]", "scene = 'level.toml'\n");
  const Outcome changed = shop.run({"replay", "a.tumble", "--json"});
  EXPECT_EQ(changed.exit, 1) << changed.err;
  EXPECT_NE(parsed(changed)["first"]["body"], nullptr) << parsed(changed)["first"];
}
#endif

constexpr const char* kMetric = "[[metric]]\nname = \"lateral_max\"\nmax = 5\nwhy = \"a test\"\n";

/// A case "stack" of the toy engine with a scene of its own.
void write_case(const Workshop& shop, const std::string& more = "", const std::string& require = "") {
  shop.write("golden/cases/stack/stack.txt", "0.5 1.5 2.5 3.5\n");
  shop.write("golden/cases/stack/metrics.toml",
             require + "[engine]\ntitle = \"a stack\"\ncategory = \"towers of toys\"\nscene = \"stack.txt\"\n" + more +
                 kMetric);
}

TEST(EngineCase, NeedsNoSceneOfOursAndIsStaleWhereAnInputFileChanged) {
  const Workshop shop;
  write_project(shop, std::string(TUMBLE_TOY_ENGINE) + " --scene {scene} --log {log}");
  write_case(shop);
  const Outcome blessed = shop.run({"bless", "stack", "--reason", "a test"});
  ASSERT_EQ(blessed.exit, 0) << blessed.err;
  const Outcome passed = shop.run({"check", "--json"});
  EXPECT_EQ(passed.exit, 0) << passed.out;
  const ordered_json one = parsed(passed)["cases"][0];
  EXPECT_EQ(one["category"], "towers of toys");
  EXPECT_EQ(one["title"], "a stack");
  EXPECT_EQ(one["bodies"], 4);
  EXPECT_EQ(one["verdicts"]["exact"]["outcome"], "pass");
  EXPECT_EQ(shop.run({"check", "--category", "towers of toys"}).exit, 0);
  EXPECT_EQ(shop.run({"check", "--category", "stacking"}).exit, 2);
  const std::string line = one["reproduce"];
  EXPECT_FALSE(says(line, "cd ")) << line;
  EXPECT_EQ(std::system(("cd '" + shop.path("") + "' && " + line).c_str()), 0) << line;
  EXPECT_EQ(shop.run({"info", "stack.tumble"}).exit, 0) << line;

  shop.write("golden/cases/stack/stack.txt", "0.5 1.5 2.5 3.6\n");
  const Outcome stale = shop.run({"check", "--report", "r"});
  EXPECT_EQ(stale.exit, 1);
  EXPECT_TRUE(says(stale.out,
                   "stale: the input files are not those that were blessed: stack.txt, line 1: "
                   "0.5 1.5 2.5 3.5 → 0.5 1.5 2.5 3.6"))
      << stale.out;
  EXPECT_TRUE(says(shop.read("r/index.html"), "<h3>Lines of its files that changed</h3>"));
  shop.write("golden/cases/stack/stack.txt", "0.5 1.5 2.5 3.5\n");
  write_project(shop, std::string(TUMBLE_TOY_ENGINE) + " --scene {scene} --log {log} --fault 9");
  const Outcome changed = shop.run({"check", "--report", "r"});
  EXPECT_EQ(changed.exit, 1) << changed.out;
  EXPECT_TRUE(says(changed.out, "bits moved from step 1")) << changed.out;
}

TEST(EngineCase, FilesThatNothingReadsAndCasesWithoutFilesAreMistakes) {
  const Workshop shop;
  write_project(shop, std::string(TUMBLE_TOY_ENGINE) + " --scene {scene} --log {log}");
  write_case(shop);
  ASSERT_EQ(shop.run({"bless", "stack", "--reason", "a test"}).exit, 0);
  shop.write("golden/cases/stack/mesh.obj", "v 0 0 0\n");
  const Outcome unread = shop.run({"check", "--report", "r"});
  EXPECT_EQ(unread.exit, 1);
  EXPECT_TRUE(says(unread.out, "unreferenced: nothing reads mesh.obj")) << unread.out;
  write_case(shop, "files = [\"mesh.obj\"]\n");
  EXPECT_TRUE(says(shop.run({"check", "--report", "r"}).out, "stale")) << "a file more is another input";
  write_case(shop, "files = [\"mesh.obj\", 3]\n");
  EXPECT_TRUE(says(shop.run({"check", "--report", "r"}).out, "[engine] key \"files\": found"));
  shop.write("golden/cases/stack/metrics.toml", std::string("[engine]\ncategory = \"x\"\n") + kMetric);
  EXPECT_TRUE(says(shop.run({"check", "--report", "r"}).out, "its input files: scene, inputs, or files"));
  std::system(("rm '" + shop.path("tumble.toml") + "'").c_str());
  write_case(shop, "files = [\"mesh.obj\"]\n");
  const Outcome none = shop.run({"check", "--report", "r"});
  EXPECT_EQ(none.exit, 2);
  EXPECT_TRUE(says(none.err, "found no tumble.toml")) << none.err;
}

TEST(EngineCase, RepeatedRunsAreJudgedAgainstTheirOwnSpread) {
  const Workshop shop;
  const std::string run = std::string(TUMBLE_TOY_ENGINE) + " --scene {scene} --log {log}";
  write_project(shop, run);
  write_case(shop, "repeat = 3\n", "require = [\"behaviour\"]\n");
  ASSERT_EQ(shop.run({"bless", "stack", "--reason", "a test"}).exit, 0);
  const ordered_json steady = parsed(shop.run({"check", "--json"}))["cases"][0];
  EXPECT_EQ(steady["runs"], 3);
  const std::string words = steady["runs_words"];
  EXPECT_TRUE(says(words, "3 runs of the engine agree in every bit compared (step lengths, inputs, counters")) << words;
  EXPECT_TRUE(says(words, "the engine's own spread is 0, so metrics are judged against the blessed values")) << words;
  const std::string line = shop.run({"check"}).out;
  EXPECT_TRUE(says(line, "; 3 runs of the engine agree in every bit compared ")) << line;
  EXPECT_FALSE(says(line, "step lengths")) << "one line a case; JSON and page have the rest";
  EXPECT_EQ(steady["verdicts"]["exact"]["outcome"], "pass");
  write_project(shop, run + " --jitter");
  const Outcome shaky = shop.run({"check", "--json", "--report", "r"});
  EXPECT_EQ(shaky.exit, 0) << shaky.out;
  const ordered_json one = parsed(shaky)["cases"][0];
  EXPECT_TRUE(says(one["runs_words"], "3 runs of the engine differ among themselves by up to ")) << one["runs_words"];
  EXPECT_TRUE(says(one["runs_words"], "each metric is judged against its own spread"));
  EXPECT_EQ(one["verdicts"]["exact"]["outcome"], "fail");
  EXPECT_GT(one["metrics"][0]["spread"].get<double>(), 0);
  EXPECT_EQ(shop.run({"check", "--require", "exact", "--report", "r"}).exit, 1);
  std::string rules = shop.read("golden/cases/stack/metrics.toml");
  shop.write("golden/cases/stack/metrics.toml", rules.replace(rules.find("max = 5"), 7, "max = -1"));
  const Outcome beyond = shop.run({"check", "--report", "r"});
  EXPECT_EQ(beyond.exit, 1);
  EXPECT_TRUE(says(beyond.out + beyond.err, "; 3 runs gave ")) << beyond.out << beyond.err;
}

// A golden that the engine itself does not meet again would fail by itself.
TEST(EngineCase, IsBlessedForEveryBitOnlyWhereASecondRunHasThem) {
  const Workshop shop;
  const std::string run = std::string(TUMBLE_TOY_ENGINE) + " --scene {scene} --log {log}";
  write_project(shop, run + " --jitter");
  write_case(shop, "", "require = [\"exact\"]\n");
  const Outcome refused = shop.run({"bless", "stack", "--reason", "a test"});
  EXPECT_EQ(refused.exit, 2) << refused.out;
  EXPECT_TRUE(says(refused.err, "the engine does not repeat itself: run 2 differs from run 1")) << refused.err;
  write_case(shop, "", "require = [\"behaviour\"]\n");
  EXPECT_EQ(shop.run({"bless", "stack", "--reason", "a test"}).exit, 0);
  write_case(shop, "", "require = [\"exact\"]\n");
  write_project(shop, run);
  EXPECT_EQ(shop.run({"bless", "stack", "--reason", "a test"}).exit, 0);
  EXPECT_EQ(shop.run({"bless", "stack", "--reason", "a test", "--json"}).exit, 0);
}

}  // namespace
}  // namespace tumble::test
