// What `tumble hunt` says of scenes that were judged, and of those that were not.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/program.h"

namespace tumble::test {
namespace {

using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

const std::string kKnownScenes = std::string(TUMBLE_SOURCE_DIR) + "/tests/data/hunt_known";

bool tells(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// The known failures lie on no slope.
TEST(HuntAnswers, AFolderThatNothingCouldBeAskedOfIsNotWhole) {
  const Workshop shop;
  const Outcome run = shop.run({"hunt", "--judge", kKnownScenes, "--relation", "slope"});
  EXPECT_TRUE(tells(run.out, "nothing was judged: no relation or law could be asked of any scene")) << run.out;
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
}

}  // namespace
}  // namespace tumble::test
