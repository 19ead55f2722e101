// Several inputs before one step, and which of them blame names; an interruption.
#include <gtest/gtest.h>

#include <string>

#include "tests/replay/blame_story.h"

namespace tumble::replay {
namespace {

using sim::Method;

// Each of these inputs is of the step, and only some can have written the value.
TEST(Blame, NamesTheInputsThatChangedTheValue) {
  for (const Method method : kMethods) {
    sim::SceneDef scene = floating(method, {}, 12);
    sim::BoxDef asleep = test::cube(2, {9, 0, 5});
    asleep.frozen = true;
    scene.boxes.push_back(asleep);
    scene.boxes.push_back(test::cube(3, {20, 0, 5}));
    scene.inputs = {{10, sim::SetVelocity{1, {0, 1, 0}, {0, 0, 0}}},
                    {10, sim::Push{1, {2, 0, 0}, true, {0, 0, 0}}},
                    {10, sim::Wake{2}},
                    {10, sim::Remove{3}}};
    const auto texts = [&](sim::BodyId body, const char* field) {
      const Blame found = blame_of(scene, {body, field, 10, 1});
      EXPECT_EQ(found.answers.size(), 1U);
      EXPECT_EQ(found.answers.at(0).phase, "inputs") << story(found);
      EXPECT_TRUE(found.complete) << story(found);
      return found.answers.at(0).text;
    };
    EXPECT_TRUE(texts(1, "velocity.x").starts_with("push of body 1"));
    EXPECT_TRUE(texts(1, "velocity.y").starts_with("set_velocity of body 1"));
    EXPECT_EQ(texts(2, "frozen"), "wake of body 2");
  }
}

TEST(Blame, NamesEachOfSeveralInputsThatChangedAValue) {
  const sim::Push first{1, {2, 0, 0}, true, {0, 0, 0}}, second{1, {3, 0, 0}, true, {0, 0, 0}};
  const sim::SceneDef scene = floating(
      Method::kLayered, {{4, first}, {4, sim::SetVelocity{1, {1, 0, 0}, {0, 0, 0}}}, {4, first}, {4, second}}, 6);
  const Blame all = blame_of(scene, {1, "velocity.x", 4, 9});
  ASSERT_EQ(all.answers.size(), 3U) << story(all);
  EXPECT_NE(all.answers[0].text.find("impulse (3, 0, 0) N s; number 3 of the 3 inputs"), std::string::npos)
      << story(all);
  EXPECT_NE(all.answers[1].text.find("number 2 of the 3"), std::string::npos) << story(all);
  EXPECT_TRUE(all.answers[2].text.starts_with("set_velocity")) << story(all);
  EXPECT_EQ(all.answers[0].before, all.answers[1].after);
  EXPECT_TRUE(all.complete);
  const Blame one = blame_of(scene, {1, "velocity.x", 4, 1});
  EXPECT_EQ(one.answers.at(0).text, all.answers[0].text);
  EXPECT_FALSE(one.complete) << "others changed it before";
}

TEST(Blame, AnInterruptionIsNoEndOfTheChain) {
  const sim::SceneDef scene = floating(Method::kLayered, {{4, sim::Push{1, {3, 0, 0}, true, {0, 0, 0}}}}, 40);
  const Bytes bytes = record_to_memory(scene, {}, 6);
  std::size_t calls = 0;
  Result<LogReader> whole = open_memory(bytes);
  ASSERT_TRUE(blame(*whole, {1, "position.x", 40, 9}, [&](std::uint64_t, std::uint64_t) { return ++calls > 0; }).ok());
  ASSERT_GT(calls, 2U);
  for (std::size_t stop = 1; stop <= calls; ++stop) {
    Result<LogReader> log = open_memory(bytes);
    std::size_t left = stop;
    const Result<Blame> found =
        blame(*log, {1, "position.x", 40, 9}, [&](std::uint64_t, std::uint64_t) { return --left > 0; });
    ASSERT_FALSE(found.ok()) << "stopped at call " << stop;
    EXPECT_EQ(found.error().kind, ErrorKind::kCannotFinish);
    EXPECT_NE(found.error().message.find("interrupted"), std::string::npos) << found.error().message;
  }
}

}  // namespace
}  // namespace tumble::replay
