// What a hunt leaves behind and what it may not wait for: other hunts, engines that hang, files that are none.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/program.h"

namespace tumble::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

bool names(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

void write_engine(const Workshop& shop, const std::string& run, const std::string& claims = "") {
  shop.write("tumble.toml", "[engine]\nshell = true\nrun = '''" + run + " # {scene} {log}'''\n" + claims);
}

// A program that hangs fails its test by this.
constexpr const char* kAtMostAMinute = "timeout -k 5 60 \"$0\" \"$@\"; exit $?; ";

TEST(HuntFolder, IsOneHunts) {
  const Workshop shop;
  write_engine(shop, "sleep 2; exit 2");
  const Outcome second = shop.run_after(
      "\"$0\" \"$@\" >/dev/null 2>&1 & p=$!; sleep 1; \"$0\" \"$@\"; code=$?; kill $p; wait $p; exit $code; ",
      {"hunt", "--engine", "--count", "3", "--threads", "1", "--folder", "kept"});
  EXPECT_EQ(second.exit, 2) << second.out;
  EXPECT_TRUE(names(second.err, "kept: a hunt works there, process ")) << second.err;
  EXPECT_TRUE(names(second.err, "hunt --engine --count 3")) << second.err;
  EXPECT_FALSE(fs::exists(shop.path("kept/hunt.lock"))) << "the first is gone, and its lock with it";
}

TEST(HuntFolder, TellsNoNearestOfARelationThatHasNone) {
  const Workshop shop;
  const Words words = {"hunt", "--count", "3", "--relation", "repeat", "--relation", "flight", "--relation", "bounce"};
  Words kept = words;
  kept.insert(kept.end(), {"--folder", "kept", "--json"});
  const Outcome first = shop.run(kept), again = shop.run(kept);
  ASSERT_EQ(first.exit, 0) << first.err;
  EXPECT_EQ(first.out, again.out);
  const Json relations = Json::parse(first.out).at("relations");
  for (const auto& [name, tally] : relations.items()) {
    const bool none = name == "repeat" || tally.at("held") == 0;
    EXPECT_EQ(tally.at("nearest").is_null(), none) << name << tally;
    EXPECT_EQ(tally.at("nearest_number").is_null(), none) << name << tally;
  }
}

TEST(HuntFolder, HoldsItsHuntFromTheStart) {
  const Workshop shop;
  write_engine(shop, "sleep 4; exit 2");
  const Outcome killed = shop.run_after("\"$0\" \"$@\" & p=$!; sleep 1; kill -9 $p; exit 0; ",
                                        {"hunt", "--engine", "--count", "3", "--folder", "kept"});
  EXPECT_EQ(killed.exit, 0);
  const Json json = Json::parse(shop.read("kept/hunt.json"), nullptr, false);
  ASSERT_TRUE(json.is_object());
  EXPECT_EQ(json.at("scenes"), 0);
  EXPECT_EQ(json.at("ended"), false);
}

TEST(HuntFolder, AnInterruptEndsTheEngineAndLeavesNothing) {
  const Workshop shop;
  write_engine(shop, "sleep 50 & echo $! >>pids; wait");
  fs::create_directory(shop.path("tmp"));
  const Outcome run =
      shop.run_after("export TMPDIR=$PWD/tmp; timeout --preserve-status -s INT 3 \"$0\" \"$@\"; exit $?; ",
                     {"hunt", "--engine", "--count", "3"});
  EXPECT_EQ(run.exit, 4) << run.err;
  EXPECT_TRUE(names(run.err, "interrupted")) << run.err;
  EXPECT_TRUE(fs::is_empty(shop.path("tmp")));
  std::ifstream pids(shop.path("pids"));
  int pid = 0, seen = 0;
  while (pids >> pid) {
    ++seen;
    for (int tenths = 0; tenths < 100 && ::kill(pid, 0) == 0; ++tenths) ::usleep(100'000);  // until it is waited for
    EXPECT_NE(::kill(pid, 0), 0) << pid;
  }
  EXPECT_GT(seen, 0);
}

TEST(HuntFolder, NoPipeIsWaitedFor) {
  const Workshop shop;
  write_engine(shop, "mkfifo {log}");
  const Outcome run = shop.run_after(kAtMostAMinute, {"hunt", "--engine", "--count", "1", "--unshrunk"});
  EXPECT_EQ(run.exit, 4) << run.out;
  EXPECT_TRUE(names(run.err, "wrote no file where the log should be")) << run.err;
  shop.write("scenes/a.toml", shop.run({"hunt", "--print", "1"}).out);
  ASSERT_EQ(::mkfifo(shop.path("scenes/b.toml").c_str(), 0600), 0);
  const Outcome judged = shop.run_after(kAtMostAMinute, {"hunt", "--judge", "scenes"});
  EXPECT_EQ(judged.exit, 2) << judged.out;
  EXPECT_TRUE(names(judged.err, "scenes/b.toml: is no file, but a pipe or a device")) << judged.err;
}

// Shrinking one finding takes hundreds of runs of half a second.
TEST(HuntFolder, ATimeEndsShrinkingToo) {
  const Workshop shop;
  write_engine(shop, "sleep 0.5; '" TUMBLE_PROGRAM "' record {scene} -o {log} --quiet --set world.gravity=[0,0,-9.8]",
               "[engine.claims]\nflight = true\n");
  const Outcome run = shop.run_after(kAtMostAMinute, {"hunt", "--engine", "--seed", "5", "--time", "3", "--relation",
                                                      "flight", "--threads", "2", "--json"});
  EXPECT_EQ(run.exit, 1) << run.err;
  const Json json = Json::parse(run.out, nullptr, false);
  ASSERT_TRUE(json.is_object() && !json.at("findings").empty()) << run.out;
  EXPECT_EQ(json.at("findings").at(0).at("shrunk").at("least"), false);
}

TEST(HuntFolder, ACorpusNamesAllThatIsWrongInIt) {
  const Workshop shop;
  const std::string scene = shop.run({"hunt", "--print", "1"}).out;
  shop.write("scenes/a.toml", scene);
  shop.write("scenes/b.toml", "[world\n");
  shop.write("scenes/c.toml", "title = 3\n");
  for (const Words& words : {Words{"hunt", "--judge", "scenes"},
                             {"hunt", "--corpus", "scenes", "--count", "1"},
                             {"hunt", "--corpus", "sum", "--merge", "scenes"}}) {
    const Outcome run = shop.run(words);
    EXPECT_EQ(run.exit, 2) << run.out;
    EXPECT_TRUE(names(run.err, "scenes: 2 of 3 files cannot be used; mend or remove")) << run.err;
    EXPECT_TRUE(names(run.err, "scenes/b.toml:1:") && names(run.err, "scenes/c.toml:1:")) << run.err;
  }
  shop.write("scenes/0123456789abcdef.toml", scene.substr(0, scene.size() / 2));  // named as by the text that it had
  const Outcome cut = shop.run({"hunt", "--judge", "scenes"});
  EXPECT_EQ(cut.exit, 3) << cut.err;
  EXPECT_TRUE(names(cut.err, "0123456789abcdef.toml: was cut or changed")) << cut.err;
}

TEST(HuntFolder, AnEmptyNameIsNone) {
  const Workshop shop;
  for (const Words& words : {Words{"hunt", "--count", "1", "--folder", ""},
                             {"hunt", "--count", "1", "--corpus", ""},
                             {"check", "--report", ""},
                             {"record", "tower", "-o", ""}}) {
    const Outcome run = shop.run(words);
    EXPECT_EQ(run.exit, 2) << words.front() << run.out;
    EXPECT_TRUE(names(run.err, "found \"\", wanted a value")) << run.err;
  }
}

// What is refused touches nothing.
TEST(CheckMerge, LeavesAReportThatIsThere) {
  const Workshop shop;
  for (const char* name : {"report/report.json", "report/bundle.json", "report/index.html"})
    shop.write(name, "{\"schema\": \"urn:tumble:json:1:check\"}");
  EXPECT_EQ(shop.run({"check", "--merge", "nowhere", "--report", "report"}).exit, 2);
  for (const char* name : {"report/report.json", "report/bundle.json", "report/index.html"})
    EXPECT_TRUE(fs::exists(shop.path(name))) << name;
  fs::create_directories(shop.path("all/shard-1"));
  const Outcome above = shop.run({"check", "--merge", "all/shard-1", "--report", "all"});
  EXPECT_EQ(above.exit, 2);
  EXPECT_TRUE(names(above.err, "--report: all: holds all/shard-1, a shard's report")) << above.err;
}

// An engine that fails is no slip of the command line, whichever command runs it.
TEST(Engine, ThatFailsEndsBlessWithStatusFour) {
  const Workshop shop;
  shop.write("suite/cases/c/scene.toml", shop.run({"hunt", "--print", "1"}).out);
  shop.write(
      "suite/cases/c/metrics.toml",
      "[command]\nrun = \"exit 3 # {scene} {log}\"\n[[metric]]\nname = \"lost\"\nmax = 0.0\nwhy = \"nothing falls\"\n");
  const Outcome run = shop.run({"bless", "--suite", "suite", "c", "--reason", "test"});
  EXPECT_EQ(run.exit, 4) << run.err;
  EXPECT_TRUE(names(run.err, "ended with status 3")) << run.err;
}

}  // namespace
}  // namespace tumble::test
