// What `tumble hunt` says of scenes that were judged, and of those that were not.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/program.h"

namespace tumble::test {
namespace {

using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

const std::string kKnownScenes = std::string(TUMBLE_SOURCE_DIR) + "/tests/data/hunt_known";

bool tells(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

// Each scene of tests/data/hunt_known breaks the relation that its name begins with, and docs/hunting.md lists it. A
// scene that breaks nothing any more is mended and moves to tests/data/hunt.
TEST(HuntAnswers, KnownFailuresAreFoundAndListed) {
  const Workshop shop;
  const Outcome judged = shop.run({"hunt", "--judge", kKnownScenes, "--json"});
  ASSERT_EQ(judged.exit, 1) << judged.err;
  std::map<std::string, std::string> broken;
  const Json report = Json::parse(judged.out);
  for (const Json& one : report.at("broken")) {
    broken[std::filesystem::path(one.at("file").get<std::string>()).stem()] += one.at("relation").get<std::string>();
  }
  const std::string page = text_of(std::filesystem::path(TUMBLE_SOURCE_DIR) / "docs/hunting.md");
  std::size_t scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kKnownScenes)) {
    const std::string name = entry.path().stem();
    EXPECT_EQ(broken[name], name.substr(0, name.find('_'))) << name;
    EXPECT_TRUE(tells(page, "\n| `" + name + "` |")) << name << " has no row in docs/hunting.md";
    ++scenes;
  }
  EXPECT_EQ(broken.size(), scenes);
  std::istringstream lines(page);
  const std::regex row("^\\| `[a-z]+_[0-9]+_[0-9]+` \\|");
  std::size_t rows = 0;
  for (std::string line; std::getline(lines, line);) {
    rows += std::regex_search(line, row) ? 1U : 0U;
  }
  EXPECT_EQ(rows, scenes) << "docs/hunting.md has a row of a scene that is not there, or has it twice";
}

// The known failures lie on no slope.
TEST(HuntAnswers, AFolderThatNothingCouldBeAskedOfIsNotWhole) {
  const Workshop shop;
  const Outcome run = shop.run({"hunt", "--judge", kKnownScenes, "--relation", "slope"});
  EXPECT_EQ(run.exit, 4);
  EXPECT_TRUE(tells(run.err, "nothing was judged: no relation or law could be asked of any of ")) << run.err;
  EXPECT_FALSE(tells(run.out, "0 broken")) << run.out;
}

// A round is of 80 scenes; of an engine that takes half a second each, a hunt of a second ends long before.
TEST(HuntAnswers, ATimeThatEndsARoundKeepsItsScenes) {
  const Workshop shop;
  shop.write("tumble.toml",
             "[engine]\nshell = true\nrun = \"sleep 0.5; '" TUMBLE_PROGRAM "' record {scene} -o {log} --quiet\"\n");
  const auto scenes_after = [&shop] {
    const Outcome run = shop.run(
        {"hunt", "--engine", "--time", "1", "--relation", "finishes", "--folder", "kept", "--threads", "1", "--json"});
    EXPECT_EQ(run.exit, 0) << run.err;
    return Json::parse(run.out).at("scenes").get<int>();
  };
  const int first = scenes_after();
  EXPECT_GE(first, 1);
  EXPECT_LT(first, 10);
  EXPECT_GT(scenes_after(), first);
}

TEST(HuntAnswers, AShardWithoutScenesSaysSo) {
  const Workshop shop;
  const Outcome run = shop.run({"hunt", "--count", "2", "--shard", "5/9"});
  EXPECT_EQ(run.exit, 0) << run.err;
  EXPECT_TRUE(tells(run.out, "nothing was judged: none of 2 scenes is the shard's")) << run.out;
  for (const auto& [shard, is_empty] : {std::pair{"5/9", true}, std::pair{"2/9", false}}) {
    const Outcome told = shop.run({"hunt", "--count", "2", "--shard", shard, "--json"});
    EXPECT_EQ(told.exit, 0) << told.err;
    EXPECT_EQ(Json::parse(told.out).at("is_empty_shard"), is_empty) << shard;
  }
}

// An engine of which no scene gives a session, and claims that could be asked of none, are no result.
TEST(HuntAnswers, AHuntThatJudgedNothingEndsSo) {
  const Workshop shop;
  const auto expect_nothing = [&shop](const std::string& run, const std::string& claims, const std::string& why) {
    shop.write("tumble.toml", "[engine]\nshell = true\nrun = '''" + run + "'''\n" + claims);
    const Outcome hunt = shop.run({"hunt", "--engine", "--count", "3", "--unshrunk"});
    EXPECT_EQ(hunt.exit, 4) << hunt.out;
    EXPECT_TRUE(tells(hunt.err, "nothing was judged: " + why)) << hunt.err;
    EXPECT_FALSE(tells(hunt.out, "no scene broke")) << hunt.out;
  };
  expect_nothing("exit 127 # {scene} {log}", "",
                 "the engine came to the end of no scene that it could be judged by; scene 0: ");
  expect_nothing("exit 1 # {scene} {log}", "[engine.claims]\nrepeat = true\n",
                 "the engine came to the end of no scene");
  expect_nothing("'" TUMBLE_PROGRAM "' record {scene} -o {log} --quiet", "[engine.claims]\nbounce = true\n",
                 "no scene could be judged by what the engine claims: bounce");
  const Outcome own = shop.run({"hunt", "--engine", "--count", "1", "--relation", "threads"});
  EXPECT_EQ(own.exit, 2);
  EXPECT_TRUE(tells(own.err, "--relation: found \"threads\", which compares parts of Tumble")) << own.err;
  shop.write("tumble.toml", "[engine]\nrun = 'engine {log}'\n");
  const Outcome blind = shop.run({"hunt", "--engine", "--count", "1"});
  EXPECT_EQ(blind.exit, 2);
  EXPECT_TRUE(tells(blind.err, "[engine] run: found no {scene} in \"engine {log}\"")) << blind.err;
}

// What --judge and --merge would leave aside is refused.
TEST(HuntAnswers, NoArgumentIsIgnored) {
  const Workshop shop;
  const std::vector<Words> hunting = {{"--seed", "3"},    {"--count", "1"}, {"--time", "1"},
                                      {"--shard", "2/2"}, {"--print", "3"}, {"--unshrunk"}};
  const auto expect_refused = [&shop](Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    const Outcome run = shop.run(words);
    EXPECT_EQ(run.exit, 2) << more.front() << run.out;
    EXPECT_TRUE(tells(run.err, more.front())) << run.err;
  };
  const Words judge = {"hunt", "--judge", kKnownScenes, "--relation", "slope"};
  const Words merge = {"hunt", "--merge", kKnownScenes, "--corpus", "sum"};
  for (const Words& more : hunting) {
    expect_refused(judge, more);
    expect_refused(merge, more);
  }
  expect_refused(judge, {"--folder", "kept"});
  expect_refused(judge, {"--merge", "other"});
  expect_refused(merge, {"--engine"});
  expect_refused(merge, {"--folder", "kept"});
  expect_refused(merge, {"--relation", "slope"});
  expect_refused(merge, {"--against", TUMBLE_PROGRAM});
}

// Of an engine only what it claims is judged: in a folder of scenes as in a hunt.
TEST(HuntAnswers, AFolderIsJudgedByTheClaimsOfAnEngine) {
  const Workshop shop;
  const auto judged = [&shop](const std::string& claims) {
    shop.write("tumble.toml", "[engine]\nrun = \"'" TUMBLE_PROGRAM "' record {scene} -o {log} --quiet\"\n" + claims);
    return shop.run({"hunt", "--engine", "--judge", kKnownScenes, "--relation", "energy", "--relation", "slope",
                     "--relation", "finishes", "--json"});
  };
  const Outcome measured = judged("");
  EXPECT_EQ(measured.exit, 0) << measured.err;
  EXPECT_GT(Json::parse(measured.out).at("relations").at("energy").at("broken"), 0U);
  EXPECT_EQ(judged("[engine.claims]\nenergy = false\n").exit, 0);
  const Outcome claimed = judged("[engine.claims]\nenergy = true\n");
  EXPECT_EQ(claimed.exit, 1) << claimed.err;
  EXPECT_EQ(Json::parse(claimed.out).at("claimed"), Json({"energy"}));
  const Outcome none = judged("[engine.claims]\nslope = true\n");
  EXPECT_EQ(none.exit, 4) << none.out;
  EXPECT_TRUE(tells(none.err, "nothing was judged: no scene could be judged by what the engine claims: slope"));
}

}  // namespace
}  // namespace tumble::test
