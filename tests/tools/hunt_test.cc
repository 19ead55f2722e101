// `tumble hunt` as docs/hunting.md describes it.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/program.h"

namespace tumble::test {
namespace {

using Json = nlohmann::ordered_json;

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// Another build of tumble, whose gravity is weaker by a thousandth.
std::string other_build(const Workshop& shop) {
  shop.write("other.sh", "#!/bin/sh\nexec " TUMBLE_PROGRAM " \"$@\" --set 'world.gravity=[0,0,-9.8]'\n");
  std::filesystem::permissions(shop.path("other.sh"), std::filesystem::perms::owner_all);
  return shop.path("other.sh");
}

TEST(Hunt, TellsHowOftenEachRelationWasJudged) {
  const Workshop shop;
  const Outcome run =
      shop.run({"hunt", "--seed", "5", "--count", "20", "--relation", "ids", "--relation", "slope", "--json"});
  ASSERT_EQ(run.exit, 0) << run.err << run.out;
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json.at("scenes"), 20);
  const Json& ids = json.at("relations").at("ids");
  EXPECT_EQ(ids.at("held").get<int>() + ids.at("not_applicable").get<int>(), 20 - json.at("no_scenes").get<int>());
  EXPECT_GT(json.at("relations").at("slope").at("not_applicable").get<int>(), 0);
  EXPECT_EQ(json.at("relations").size(), 2U);
}

TEST(Hunt, FindsTheSameWhateverTheNumberOfThreads) {
  const Workshop shop;
  const std::string other = other_build(shop);
  std::string first;
  for (const char* threads : {"1", "3"}) {
    const Outcome run = shop.run({"hunt", "--seed", "2", "--count", "25", "--relation", "finishes", "--against", other,
                                  "--threads", threads, "--json"});
    ASSERT_EQ(run.exit, 1) << run.err;
    if (first.empty()) first = run.out;
    EXPECT_EQ(run.out, first);
  }
}

TEST(Hunt, ShrinksToACaseThatCanBeBlessed) {
  const Workshop shop;
  const Outcome run = shop.run({"hunt", "--seed", "2", "--count", "10", "--relation", "finishes", "--against",
                                other_build(shop), "--folder", "kept"});
  ASSERT_EQ(run.exit, 1) << run.err;
  EXPECT_TRUE(says(run.out, "against")) << run.out;
  const Json json = Json::parse(shop.read("kept/hunt.json"));
  ASSERT_FALSE(json.at("findings").empty());
  const Json& found = json.at("findings").at(0);
  ASSERT_TRUE(found.at("shrunk").is_object());
  EXPECT_EQ(found.at("shrunk").at("bodies"), 1);
  EXPECT_EQ(found.at("shrunk").at("steps"), 1);
  const std::string name = found.at("name");
  EXPECT_TRUE(says(shop.read("kept/findings/" + name + ".toml"), "scene "));
  EXPECT_TRUE(
      says(shop.read("kept/cases/" + name + "/metrics.toml"), ", tumble " + json.at("program").get<std::string>()));
  const Outcome blessed = shop.run({"bless", "--suite", "kept", "--reason", "found by a hunt", name});
  EXPECT_EQ(blessed.exit, 0) << blessed.err << shop.read("kept/cases/" + name + "/scene.toml");
  EXPECT_EQ(shop.run({"check", "--suite", "kept", name}).exit, 0);
}

TEST(Hunt, GoesOnWithTheHuntInItsFolder) {
  const Workshop shop;
  const std::vector<std::string> base = {"hunt", "--seed", "5", "--relation", "mirror_x", "--folder", "kept", "--json"};
  const auto run = [&](const char* count) {
    std::vector<std::string> words = base;
    words.insert(words.end(), {"--count", count});
    return shop.run(words);
  };
  ASSERT_EQ(run("13").exit, 0);
  const Outcome on = run("30");
  ASSERT_EQ(on.exit, 0) << on.err;
  const Outcome at_once = shop.run({"hunt", "--seed", "5", "--relation", "mirror_x", "--json", "--count", "30"});
  EXPECT_EQ(on.out, at_once.out);
  // Of another seed, or by other relations, it is another hunt.
  const Outcome seed = shop.run({"hunt", "--seed", "6", "--relation", "mirror_x", "--folder", "kept", "--count", "40"});
  EXPECT_EQ(seed.exit, 2);
  EXPECT_TRUE(says(seed.err, "another seed")) << seed.err;
  const Outcome others = shop.run({"hunt", "--seed", "5", "--relation", "ids", "--folder", "kept", "--count", "40"});
  EXPECT_EQ(others.exit, 2);
  EXPECT_TRUE(says(others.err, "relations")) << others.err;
  shop.write("kept/hunt.json", "{\"format\": 2}");
  EXPECT_EQ(run("40").exit, 3) << "damaged";
}

TEST(Hunt, PrintsASceneThatCanBeRecorded) {
  const Workshop shop;
  const Outcome printed = shop.run({"hunt", "--seed", "5", "--print", "17"});
  ASSERT_EQ(printed.exit, 0);
  shop.write("s.toml", printed.out);
  EXPECT_EQ(shop.run({"record", "s.toml", "-o", "s.tumble"}).exit, 0);
}

TEST(Hunt, GrowsACorpusThatCanBeJudged) {
  const Workshop shop;
  const Outcome run =
      shop.run({"hunt", "--seed", "5", "--count", "12", "--relation", "ids", "--corpus", "corpus", "--json"});
  ASSERT_EQ(run.exit, 0) << run.err;
  const Outcome judged = shop.run({"hunt", "--judge", "corpus", "--relation", "ids", "--json"});
  ASSERT_EQ(judged.exit, 0) << judged.err;
  EXPECT_GE(Json::parse(judged.out).at("scenes").get<int>(), 3);
  // Into an empty corpus all that matters is copied.
  const Outcome merged = shop.run({"hunt", "--corpus", "other", "--merge", "corpus", "--json"});
  ASSERT_EQ(merged.exit, 0) << merged.err;
  EXPECT_GE(Json::parse(merged.out).at("features").size(), 10U);
  shop.write("corpus/bad.toml", "[[box]]\nsize = 3\n");
  EXPECT_EQ(shop.run({"hunt", "--judge", "corpus"}).exit, 2);
  EXPECT_EQ(shop.run({"hunt", "--judge", "none"}).exit, 2);
  EXPECT_EQ(shop.run({"hunt", "--merge", "corpus"}).exit, 2);
}

TEST(Hunt, AnotherBuildThatDoesNotStartJudgesNothing) {
  const Workshop shop;
  const Outcome run = shop.run({"hunt", "--count", "3", "--against", "/nosuch"});
  EXPECT_EQ(run.exit, 2) << run.out;
  EXPECT_TRUE(says(run.err, "where there is no file")) << run.err;
}

TEST(Hunt, CountsAndFindingsOfAFolderAgree) {
  const Workshop shop;
  ASSERT_EQ(shop.run({"hunt", "--count", "2", "--relation", "ids", "--folder", "kept"}).exit, 0);
  std::string text = shop.read("kept/hunt.json");
  const std::size_t at =
      text.find("\"broken\":0") != std::string::npos ? text.find("\"broken\":0") : text.find("\"broken\": 0");
  ASSERT_NE(at, std::string::npos) << text;
  text[text.find('0', at)] = '3';
  shop.write("kept/hunt.json", text);
  const Outcome run = shop.run({"hunt", "--count", "2", "--relation", "ids", "--folder", "kept"});
  EXPECT_EQ(run.exit, 3) << run.out;
  EXPECT_TRUE(says(run.err, "damaged: its text has the hash")) << run.err;
}

TEST(Hunt, NamesFindingsWithoutShrinkingThem) {
  const Workshop shop;
  const Outcome run = shop.run({"hunt", "--seed", "2", "--count", "10", "--relation", "finishes", "--against",
                                other_build(shop), "--unshrunk", "--json"});
  ASSERT_EQ(run.exit, 1) << run.err;
  const Json report = Json::parse(run.out);
  ASSERT_FALSE(report.at("findings").empty());
  for (const Json& found : report.at("findings")) EXPECT_TRUE(found.at("shrunk").is_null());
}

// A tumble.toml whose engine is this program, with more words on its command line.
void write_project(const Workshop& shop, const std::string& words, const std::string& claims) {
  shop.write("tumble.toml", "[engine]\nrun = \"'" TUMBLE_PROGRAM "' record {scene} -o {log} --quiet " + words +
                                "\"\n[engine.claims]\n" + claims);
}

TEST(HuntEngine, IsJudgedByWhatItClaims) {
  const Workshop shop;
  const std::vector<std::string> words = {"hunt", "--engine", "--seed", "5", "--count", "12", "--json"};
  write_project(shop, "", "ids = true\nflight = true\noverlap = false\n");
  const Outcome right = shop.run(words);
  ASSERT_EQ(right.exit, 0) << right.err << right.out;
  const Json json = Json::parse(right.out);
  EXPECT_EQ(json.at("claimed"), Json({"flight", "ids"}));
  EXPECT_TRUE(says(json.at("engine"), "record {scene}"));
  for (const char* name : {"ids", "mirror_x", "shift", "repeat", "inserted", "flight"}) {
    EXPECT_GT(json.at("relations").at(name).at("held").get<int>(), 0) << name;
    EXPECT_EQ(json.at("relations").at(name).at("broken").get<int>(), 0) << name;
  }
  EXPECT_EQ(json.at("relations").at("lanes").at("held").get<int>(), 0);  // Tumble's own
  // An engine with another gravity breaks its claim; without the claim that is measured.
  write_project(shop, "--set world.gravity=[0,0,-9.8]", "flight = true\n");
  const Outcome wrong = shop.run(words);
  EXPECT_EQ(wrong.exit, 1) << wrong.out;
  EXPECT_GT(Json::parse(wrong.out).at("relations").at("flight").at("broken").get<int>(), 0);
  write_project(shop, "--set world.gravity=[0,0,-9.8]", "ids = true\n");
  EXPECT_EQ(shop.run(words).exit, 0);
}

TEST(HuntEngine, ShrinksWhatItDoesNotHold) {
  const Workshop shop;
  write_project(shop, "--set world.gravity=[0,0,-9.8]", "flight = true\n");
  const Outcome run =
      shop.run({"hunt", "--engine", "--seed", "5", "--count", "6", "--relation", "flight", "--folder", "kept"});
  ASSERT_EQ(run.exit, 1) << run.err;
  EXPECT_TRUE(says(run.out, "CLAIMED")) << run.out;
  const Json json = Json::parse(shop.read("kept/hunt.json"));
  ASSERT_FALSE(json.at("findings").empty());
  EXPECT_EQ(json.at("findings").at(0).at("shrunk").at("bodies"), 1);
  // The folder holds the hunt of that engine.
  const Outcome own = shop.run({"hunt", "--seed", "5", "--count", "8", "--relation", "flight", "--folder", "kept"});
  EXPECT_EQ(own.exit, 2);
  EXPECT_TRUE(says(own.err, "another engine")) << own.err;
}

TEST(HuntEngine, MayRefuseAScene) {
  const Workshop shop;
  shop.write("tumble.toml", "[engine]\nshell = true\nrun = 'test -e {log} || { echo no {scene}; exit 2; }'\n");
  const Outcome run = shop.run({"hunt", "--engine", "--count", "3", "--json"});
  EXPECT_EQ(run.exit, 4) << run.err;
  EXPECT_EQ(Json::parse(run.out).at("refused"), 3);
  const Outcome told = shop.run({"hunt", "--engine", "--count", "3"});
  EXPECT_TRUE(says(told.err, "nothing was judged: the engine refused each of 3 scenes, scene 0: ")) << told.err;
  EXPECT_TRUE(says(told.err, "it printed: no /")) << told.err;
  // Any other end is a finding.
  shop.write("tumble.toml", "[engine]\nshell = true\nrun = 'exit 5 {scene} {log}'\n[engine.claims]\nfinishes = true\n");
  const Outcome fails = shop.run({"hunt", "--engine", "--count", "3", "--unshrunk"});
  EXPECT_EQ(fails.exit, 1) << fails.err;
  EXPECT_TRUE(says(fails.out, "status 5")) << fails.out;
}

// The engine's shell ends the process that judges the scene.
TEST(HuntEngine, ASceneThatEndsTheProgramStaysAFinding) {
  const Workshop shop;
  const std::vector<std::string> words = {"hunt", "--engine", "--count", "2", "--relation", "ids", "--folder", "kept"};
  shop.write("tumble.toml", "[engine]\nshell = true\nrun = 'kill -9 $PPID; : {scene} {log}'\n");
  const Outcome run = shop.run(words);
  ASSERT_EQ(run.exit, 4) << run.err << run.out;
  EXPECT_TRUE(says(run.err, "scene 0 of seed 1: Tumble's judge, and not the engine, ended by SIGKILL")) << run.err;
  const Json json = Json::parse(shop.read("kept/hunt.json"));
  ASSERT_EQ(json.at("findings").size(), 2U);
  EXPECT_EQ(json.at("findings").at(0).at("relation"), "survives");
  EXPECT_TRUE(says(json.at("findings").at(0).at("found").at("what").get<std::string>(), "SIGKILL"));
  EXPECT_EQ(json.at("relations").at("ids").at("broken"), 0);
  EXPECT_EQ(json.at("relations").at("ids").at("not_applicable"), 2);
  const Outcome on = shop.run(words);  // the folder that was written is whole
  EXPECT_EQ(on.exit, 4) << on.err;
}

TEST(HuntEngine, RefusesWhatIsNoProjectAndNoClaim) {
  const Workshop shop;
  const Outcome none = shop.run({"hunt", "--engine", "--count", "1"});
  EXPECT_EQ(none.exit, 2);
  EXPECT_TRUE(says(none.err, "found no tumble.toml")) << none.err;
  write_project(shop, "", "enrgy = true\n");
  const Outcome unknown = shop.run({"hunt", "--engine", "--count", "1"});
  EXPECT_EQ(unknown.exit, 2);
  EXPECT_TRUE(says(unknown.err, "[engine.claims]: found \"enrgy\"")) << unknown.err;
  EXPECT_TRUE(says(unknown.err, "did you mean \"energy\"?")) << unknown.err;
  write_project(shop, "", "energy = 3\n");
  EXPECT_EQ(shop.run({"hunt", "--engine", "--count", "1"}).exit, 2);
}

TEST(Hunt, ListsItsRelations) {
  const Workshop shop;
  const Outcome list = shop.run({"hunt", "--relations", "--json"});
  ASSERT_EQ(list.exit, 0);
  EXPECT_GE(Json::parse(list.out).size(), 20U);
  EXPECT_TRUE(says(shop.run({"hunt", "--relations"}).out, "Coulomb"));
}

TEST(Hunt, RefusesBadUsage) {
  const Workshop shop;
  const Outcome unknown = shop.run({"hunt", "--count", "1", "--relation", "energi"});
  EXPECT_EQ(unknown.exit, 2);
  EXPECT_TRUE(says(unknown.err, "did you mean \"energy\"?")) << unknown.err;
  for (const char* wrong : {"--count=0", "--time=-3"}) EXPECT_EQ(shop.run({"hunt", wrong}).exit, 2);
  EXPECT_EQ(shop.run({"hunt", "--print", "3", "--relations"}).exit, 2);
}

}  // namespace
}  // namespace tumble::test
