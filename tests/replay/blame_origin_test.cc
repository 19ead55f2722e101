// Where an input stands in the text of a scene: whatever that text is.
#include <gtest/gtest.h>

#include <string>

#include "replay/blame/origin.h"
#include "tests/support/sim_scenes.h"

namespace tumble::replay {
namespace {

const sim::Command kFirst = sim::Push{1, {1, 0, 0}, true, {0, 0, 0}};
const sim::Command kSecond = sim::Push{1, {2, 0, 0}, true, {0, 0, 0}};

LogHeader header_of(const std::string& text, std::vector<sim::TimedCommand> inputs) {
  sim::SceneDef scene = test::empty_space();
  scene.boxes = {test::cube(1, {0, 0, 5})};
  scene.inputs = std::move(inputs);
  LogHeader header = header_for(scene);
  header.scene_text = text;
  return header;
}

constexpr const char* kText =
    "[[box]]\n[[input]]\nstep = 10\nkind = \"push\"\n\n[[input]]\nstep = 50\nkind = \"push\"\n";

TEST(BlameOrigin, IsTheLineOfAnInput) {
  const LogHeader header = header_of(kText, {{10, kFirst}, {50, kSecond}});
  EXPECT_EQ(input_place(header, 10, kFirst), "line 2 of the scene, [[input]]");
  EXPECT_EQ(input_place(header, 50, kSecond), "line 6 of the scene, [[input]]");
  EXPECT_EQ(input_place(header, 51, kSecond), "an input made while the session ran");
}

// Such a log has the whole text, and of the inputs only those that were still to come.
TEST(BlameOrigin, IsTheLineOfAnInputInALogThatGoesOn) {
  LogHeader header = header_of(kText, {{50, kSecond}});
  header.goes_on = GoesOn{30, "before.tumble", {}, {}};
  EXPECT_EQ(input_place(header, 50, kSecond), "line 6 of the scene, [[input]]");
  header.scene_text = "";
  EXPECT_EQ(input_place(header, 50, kSecond), "an input of the session that this log goes on from");
}

TEST(BlameOrigin, IsNoLineWhereTheTextTellsNoStep) {
  for (const char* step : {"1e300", "-1", "nan", "inf", "ten", "18446744073709551616"}) {
    const LogHeader header = header_of("[[input]]\nstep = " + std::string(step) + "\n", {{10, kFirst}});
    EXPECT_EQ(input_place(header, 10, kFirst), "input 1 of the scene") << step;
  }
}

}  // namespace
}  // namespace tumble::replay
