// A body that another engine added later in a session has its name wherever a verdict names the body.
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "replay/log/byte_memory.h"
#include "tumble/golden/judge.h"
#include "tumble/replay/engine_log.h"

namespace tumble::golden {
namespace {

/// What the session with the late body does otherwise.
struct Session {
  double place = 0, knee = 0.5, grip = 0.5, impulse = 1;
  std::uint64_t from = 6;  // the step
};

replay::EngineState at(double x) {
  replay::EngineState state;
  state.position = {x, 0, 1};
  return state;
}

/// Body 1 is there from the start, body 9, "late", from step 3 on; 12 steps.
replay::LogReader session(const Session& does) {
  const auto bytes = std::make_shared<std::vector<std::byte>>();
  replay::EngineDef def;
  def.engine = {"engine", "1", 53};
  def.declared.channels = {{"grip", {replay::ChannelKind::kFloat64, replay::ChannelScope::kPair}, ""},
                           {"knee", {replay::ChannelKind::kFloat64, replay::ChannelScope::kBody}, ""}};
  def.declared.bodies = {{1, "first", {}}};
  sim::BoxDef box;
  box.id = 1;
  box.position = {0, 0, 1};
  sim::SceneDef scene;
  scene.world.dt = 0.01;
  scene.boxes = {box};
  const auto log = replay::EngineLog::create(std::make_unique<replay::MemoryByteSink>(bytes, "log"), def, scene);
  EXPECT_TRUE(log.ok());
  for (std::uint64_t k = 1; k <= 12; ++k) {
    if (k == 3) {
      sim::BoxDef late = box;
      late.id = 9;
      late.position = {3, 0, 1};
      EXPECT_TRUE((*log)->input(sim::Throw{late}).ok());
      EXPECT_TRUE((*log)->describe_body({9, "late", {}}).ok());
    }
    if (k == 6) {
      EXPECT_TRUE((*log)->input(sim::Push{9, {does.impulse, 0, 0}}).ok());
    }
    EXPECT_TRUE((*log)->set_state(1, at(0)).ok());
    if (k >= 3) {
      EXPECT_TRUE((*log)->set_state(9, at(3 + (k >= does.from ? does.place : 0))).ok());
      EXPECT_TRUE((*log)->set_value(0, k >= does.from ? does.grip : 0.5, {1, 9}).ok());
      EXPECT_TRUE((*log)->set_value(1, k >= does.from ? does.knee : 0.5, {9, 0}).ok());
    }
    EXPECT_TRUE((*log)->end_step(0.01).ok());
  }
  EXPECT_TRUE((*log)->finish().ok());
  return *replay::LogReader::open(std::make_unique<replay::MemoryByteSource>(bytes, "log"));
}

std::string told_of(const Session& does) {
  const CaseRules rules;
  replay::LogReader before = session({}), now = session(does);
  const Expected expected = judge(before, {rules, nullptr, {}, {}}).actual;
  const CaseResult result = judge(now, {rules, &expected, {}, {}}).result;
  if (!result.difference) return "no difference";
  std::string text = describe(*result.difference) + '\n' + result.difference->told + '\n';
  for (const std::string& detail : result.difference->details) text += detail + '\n';
  return text;
}

TEST(LateNames, AreInEveryDetailOfADifference) {
  const auto says = [](const Session& does, const std::string& part) {
    const std::string told = told_of(does);
    EXPECT_NE(told.find(part), std::string::npos) << "wanted \"" << part << "\" in:\n" << told;
  };
  EXPECT_EQ(told_of({}), "no difference");
  says({.place = 0.5}, "the first is body 9 (late)");
  says({.place = 0.5}, "body 9 (late), position.x");
  says({.place = 0.5}, "apart (body 9 (late), step");
  says({.knee = 0.75}, "channel.knee of body 9 (late): expected 0.5, actual 0.75");
  says({.grip = 0.75}, "channel.grip of the pair 1 (first) and 9 (late): expected 0.5, actual 0.75");
  says({.place = 0.5, .from = 3}, "body 9 (late), position.x");
  says({.knee = 0.75, .from = 3}, "channel.knee of body 9 (late): expected 0.5, actual 0.75");
  says({.impulse = 2}, "of body 9 (late): 1 → 2");
}

}  // namespace
}  // namespace tumble::golden
