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

}  // namespace
}  // namespace tumble::test
