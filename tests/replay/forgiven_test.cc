// What a comparison forgives hides nothing else: a tolerance is of its own channel, and a body that one session lacks
// makes no difference of the others.
#include <gtest/gtest.h>

#include "replay/diff/difference_report.h"
#include "replay/log/byte_memory.h"
#include "tests/support/log_memory.h"
#include "tumble/replay/compare.h"
#include "tumble/replay/engine_log.h"

namespace tumble::replay {
namespace {

/// What one session of bodies 1, 2 and 3 has.
struct Told {
  double joint_x = 1;     ///< of channel joint.x
  double height = 1;      ///< m, of body 1
  double level = 0;       ///< m/s, of body 1 along y
  bool has_third = true;  ///< body 3 is there after step 2
  const char* engine = "toy";
};

Result<LogReader> session(const Told& told) {
  auto file = std::make_shared<std::vector<std::byte>>();
  sim::SceneDef start;
  start.name = "toy";
  for (sim::BodyId id = 1; id <= 3; ++id) start.boxes.emplace_back().id = id;
  EngineDef def;
  def.engine = {told.engine, "1"};
  const ChannelType of_step = {ChannelKind::kFloat64, ChannelScope::kWorld};
  def.declared.channels = {{"joint", of_step}, {"joint.x", of_step}};
  auto log = EngineLog::create(std::make_unique<MemoryByteSink>(file, "toy.tumble"), def, start);
  if (!log.ok()) return log.error();
  for (std::uint64_t k = 1; k <= 3; ++k) {
    const bool is_gone = k >= 2 && !told.has_third;
    if (is_gone && k == 2) {
      EXPECT_TRUE((*log)->input(sim::Remove{3}).ok());
    }
    for (sim::BodyId id = 1; id <= (is_gone ? 2U : 3U); ++id) {
      EngineState state;
      state.position = {static_cast<double>(id), 0, id == 1 && k >= 2 ? told.height : 1};
      if (id == 1 && k >= 2) state.velocity.y() = told.level;
      EXPECT_TRUE((*log)->set_state(id, state).ok());
    }
    EXPECT_TRUE((*log)->set_value(0, 1.0).ok());
    EXPECT_TRUE((*log)->set_value(1, told.joint_x).ok());
    EXPECT_TRUE((*log)->end_step(0.1).ok());
  }
  EXPECT_TRUE((*log)->finish().ok());
  return LogReader::open(std::make_unique<MemoryByteSource>(file, "toy.tumble"));
}

DiffReport diff(const Told& told, const Tolerances& tolerances = {}) {
  Result<LogReader> a = session({}), b = session(told);
  EXPECT_TRUE(a.ok() && b.ok());
  Result<DiffReport> report = diff_logs(*a, *b, tolerances);
  EXPECT_TRUE(report.ok()) << report.error().message;
  return *std::move(report);
}

Tolerances tolerance(const std::string& field, double value) {
  Tolerances tolerances;
  const ChannelType of_step = {ChannelKind::kFloat64, ChannelScope::kWorld};
  EXPECT_TRUE(set_tolerance(tolerances, field, value, {{"joint", of_step}, {"joint.x", of_step}}).ok()) << field;
  return tolerances;
}

TEST(Forgiven, TheToleranceOfAChannelIsNotThatOfAnotherWhoseNameBeginsAlike) {
  const DiffReport found = diff({.joint_x = 5}, tolerance("joint", 10));
  ASSERT_TRUE(found.first) << "channel joint.x is 4 apart, and no tolerance is given for it";
  EXPECT_EQ(found.first->field, "channel.joint.x");
  EXPECT_TRUE(diff({.joint_x = 5}, tolerance("joint.x", 10)).identical());
  EXPECT_TRUE(diff({.joint_x = 5}, tolerance("channel.joint.x", 10)).identical());
}

// Of two engines, states alone are compared, and no input comes before them.
TEST(Forgiven, ABodyThatOneSessionLacksIsTheFirstDifferenceWhereTheOthersAreWithinTolerance) {
  const DiffReport near =
      diff({.height = 1 + 1e-9, .has_third = false, .engine = "other"}, tolerance("position", 1e-6));
  ASSERT_TRUE(near.first);
  EXPECT_EQ(near.first->step, 2U);
  EXPECT_TRUE(is_body_missing(*near.first)) << describe(*near.first);
  EXPECT_EQ(near.first->body, 3U);
  const DiffReport zeros = diff({.level = -0.0, .has_third = false, .engine = "other"});
  ASSERT_TRUE(zeros.first);
  EXPECT_TRUE(is_body_missing(*zeros.first)) << describe(*zeros.first);
}

// −0.0 of another engine is 0.0, so it is not what a changed mass led to.
TEST(Forgiven, AZeroOfOtherSignIsNoEffect) {
  const Told told = {.joint_x = 2, .level = -0.0};
  Result<LogReader> a = session({}), b = session(told);
  ASSERT_TRUE(a.ok() && b.ok());
  const Result<DiffReport> found = diff_logs(*a, *b);
  ASSERT_TRUE(found.ok() && found->first);
  EXPECT_EQ(found->first->field, "channel.joint.x");
  const Result<DifferenceReport> report = report_difference(*a, *b, *found);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_FALSE(report->effect) << describe(*report->effect);
}

}  // namespace
}  // namespace tumble::replay
