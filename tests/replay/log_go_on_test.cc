// Save and continue: a session that continues from any state of another one equals that one to the bit.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "replay/log/log_facts.h"
#include "replay/log/verify.h"
#include "replay/measure/measure_log.h"
#include "replay/session/state_source.h"
#include "tests/support/log_memory.h"
#include "tests/support/sim_scenes.h"
#include "tumble/replay/compare.h"
#include "tumble/replay/player.h"
#include "tumble/replay/replayer.h"

namespace tumble::replay {
namespace {

// Records the steps after state k of a log, up to its planned end.
Result<Bytes> go_on(const Bytes& from, std::uint64_t k, const GoOnOptions& options = {}) {
  Result<LogReader> log = open_memory(from);
  if (!log.ok()) return log.error();
  const auto disk = std::make_shared<Disk>();
  auto recorder = Recorder::go_on(std::make_unique<MemorySink>(disk), *log, k, options);
  if (!recorder.ok()) return recorder.error();
  while ((*recorder)->world().state().step < (*recorder)->scene().steps) {
    if (Status ok = (*recorder)->step(); !ok.ok()) return ok.error();
  }
  if (Result<LogSummary> done = (*recorder)->finish(); !done.ok()) return done.error();
  return disk->bytes;
}

// The hash of everything the future depends on, after the last step of a log.
Hash128 final_continuation(const Bytes& bytes) {
  Result<LogReader> log = open_memory(bytes);
  Result<Player> player = Player::at(*log, log->last_step());
  EXPECT_TRUE(player.ok());
  return sim::continuation_hash(player->world().state());
}

// Boxes of all shapes that hit one another, the ground and frozen bodies, with inputs in between.
sim::SceneDef chaos(sim::Method method) {
  sim::SceneDef scene = scene_with_inputs(60, method);
  for (sim::BodyId id = 20; id < 26; ++id) {
    sim::BoxDef box;
    const auto n = static_cast<double>(id - 20);
    box.id = id;
    box.size = {0.5 + 0.125 * n, 1, 0.375};
    box.position = {0.5 * n - 1.5, 0.25 * n, 5 + 0.75 * n};
    box.orientation = {1, 0.25 * n, 0.5, -0.125};
    box.spin = {n, -2, 1};
    box.velocity = {0, 0, -4};
    scene.boxes.push_back(box);
  }
  return scene;
}

TEST(GoOn, FromEveryStepTheSessionIsTheSameToTheBit) {
  for (const sim::Method method : kMethods) {
    const Bytes whole = record_to_memory(chaos(method), {}, 7);
    const Hash128 wanted = final_continuation(whole);
    for (std::uint64_t k = 0; k < 60; ++k) {
      const Result<Bytes> rest = go_on(whole, k);
      ASSERT_TRUE(rest.ok()) << rest.error().message;
      Result<LogReader> a = open_memory(whole), b = open_memory(*rest);
      ASSERT_TRUE(b.ok()) << b.error().message;
      EXPECT_EQ(b->first_state(), k);
      EXPECT_EQ(b->last_step(), 60U);
      EXPECT_EQ(*b->chain_at(60), *a->chain_at(60)) << "from step " << k;
      EXPECT_EQ(final_continuation(*rest), wanted) << "from step " << k;
    }
  }
}

// Nothing outside the state matters: a world restored at any step has the other's hidden state 20 steps later.
TEST(GoOn, EverythingTheFutureDependsOnIsInTheState) {
  for (const sim::Method method : kMethods) {
    sim::SceneDef scene = test::tumble_of_boxes(3, 11);
    test::add_thrown_cube(scene);
    scene.world.method = method;
    sim::World world = test::made(scene);
    std::vector<sim::WorldState> states;
    std::vector<Hash128> hashes;
    for (std::uint64_t k = 0; k <= 120; ++k) {
      states.push_back(world.state());
      hashes.push_back(sim::continuation_hash(world.state()));
      test::advance(world);
    }
    for (std::uint64_t k = 0; k + 20 <= 120; ++k) {
      Result<sim::World> restored = sim::World::restore(states[k]);
      ASSERT_TRUE(restored.ok());
      for (int i = 0; i < 20; ++i) test::advance(*restored);
      ASSERT_EQ(sim::continuation_hash(restored->state()), hashes[k + 20]) << "from step " << k;
    }
  }
}

// The canary of the test above: a value missing in a snapshot changes the future.
TEST(GoOn, AForgottenPartOfTheStateShows) {
  for (const sim::Method method : kMethods) {
    sim::SceneDef scene = test::tumble_of_boxes(3, 5);
    scene.world.method = method;
    sim::World world = test::made(scene);
    std::size_t noticed = 0;
    for (int k = 0; k < 60; ++k) {
      test::advance(world);
      sim::WorldState poorer = world.state();
      poorer.contact_memory.clear();
      for (std::uint16_t& planes : poorer.pairs.planes) planes = 0;
      Result<sim::World> restored = sim::World::restore(poorer);
      ASSERT_TRUE(restored.ok());
      sim::World other = world;
      for (int i = 0; i < 20; ++i) {
        test::advance(*restored);
        test::advance(other);
      }
      if (sim::continuation_hash(restored->state()) != sim::continuation_hash(other.state())) ++noticed;
    }
    EXPECT_GT(noticed, 0U);
  }
}

TEST(GoOn, ItDoesNotMatterWhichStatesTheLogHolds) {
  for (const sim::Method method : kMethods) {
    const Bytes whole = record_to_memory(chaos(method));
    for (const std::uint32_t every : {0U, 8U}) {
      RecordOptions sparse;
      sparse.states.every = every;
      const Bytes log = record_to_memory(chaos(method), sparse, 13);
      for (const std::uint64_t k : {1U, 19U, 26U, 59U}) {
        GoOnOptions options;
        options.states.every = every;
        const Result<Bytes> rest = go_on(log, k, options);
        ASSERT_TRUE(rest.ok()) << rest.error().message;
        Result<LogReader> a = open_memory(whole), b = open_memory(*rest);
        const Result<DiffReport> report = diff_logs(*a, *b);
        ASSERT_TRUE(report.ok()) << report.error().message;
        EXPECT_TRUE(report->identical()) << describe(*report->first);
        EXPECT_EQ(report->from, k);
        EXPECT_EQ(report->steps, 60 - k);
      }
    }
  }
}

TEST(GoOn, TheNewLogIsALogLikeAnyOther) {
  const Bytes whole = record_to_memory(chaos(sim::Method::kThesis), {}, 7);
  const Bytes rest = *go_on(whole, 15);
  Result<LogReader> log = open_memory(rest);
  ASSERT_TRUE(log.ok()) << log.error().message;
  ASSERT_TRUE(log->header().goes_on);
  EXPECT_EQ(log->header().goes_on->step, 15U);
  EXPECT_EQ(log->header().goes_on->log, "memory.tumble");
  EXPECT_EQ(log->step_count(), 45U);
  const VerifyReport verified = verify(*log);
  EXPECT_TRUE(verified.condition.whole()) << verified.condition.summary(log->last_step());
  EXPECT_EQ(verified.steps_checked, 45U);
  const Result<ReplayReport> replayed = replay_log(*log);
  ASSERT_TRUE(replayed.ok()) << replayed.error().message;
  EXPECT_TRUE(replayed->identical()) << describe(*replayed->first);
  EXPECT_EQ(replayed->steps, 45U);
  EXPECT_EQ(collect_facts(*log).steps_read, 45U);
  EXPECT_FALSE(log->read_step(14).ok());
  EXPECT_FALSE(log->read_step(61).ok());
  // Measured from its start, it has the metrics of the whole log from that step on.
  Result<LogReader> original = open_memory(whole);
  MeasureOptions from;
  from.from_step = 15;
  const Metrics here = *measure_log(*log), there = *measure_log(*original, from);
  EXPECT_EQ(here.energy.initial, there.energy.initial);
  EXPECT_EQ(here.energy.gain_max, there.energy.gain_max);
  EXPECT_EQ(here.stacking.drift_max, there.stacking.drift_max);
  EXPECT_EQ(here.final_hash, there.final_hash);
}

TEST(GoOn, GoesOnFromALogThatGoesOn) {
  const Bytes whole = record_to_memory(chaos(sim::Method::kLayered));
  const Bytes second = *go_on(whole, 10);
  const Bytes third = *go_on(second, 30);
  Result<LogReader> a = open_memory(whole), b = open_memory(third);
  EXPECT_EQ(b->first_state(), 30U);
  EXPECT_EQ(*b->chain_at(60), *a->chain_at(60));
}

TEST(GoOn, InputsCanBeLeftOutAndTheEndMoved) {
  const sim::SceneDef scene = chaos(sim::Method::kThesis);
  const Bytes whole = record_to_memory(scene);
  GoOnOptions quiet;
  quiet.keep_inputs = false;
  quiet.steps = 4;
  const Bytes rest = *go_on(whole, 15, quiet);
  Result<LogReader> log = open_memory(rest);
  EXPECT_TRUE(log->header().scene.inputs.empty());
  EXPECT_EQ(log->last_step(), 19U);
  Result<LogReader> original = open_memory(whole);
  const Result<DiffReport> report = diff_logs(*original, *log);
  ASSERT_TRUE(report.ok());
  ASSERT_TRUE(report->first);
  EXPECT_EQ(report->first->step, 17U) << "where the inputs were";
  GoOnOptions longer;
  longer.seconds = 0.5;
  Result<LogReader> beyond = open_memory(*go_on(whole, 60, longer));
  EXPECT_EQ(beyond->last_step(), 75U) << "at 1/30 s, which an input had set";
  EXPECT_FALSE(go_on(whole, 60).ok()) << "nothing is planned after the end";
  EXPECT_FALSE(go_on(whole, 61, longer).ok());
}

TEST(GoOn, LogsWithoutACommonStepCannotBeCompared) {
  const Bytes whole = record_to_memory(chaos(sim::Method::kThesis));
  GoOnOptions two;
  two.steps = 2;
  Result<LogReader> early = open_memory(*go_on(whole, 3, two)), late = open_memory(*go_on(whole, 15));
  const Result<DiffReport> report = diff_logs(*early, *late);
  ASSERT_FALSE(report.ok());
  EXPECT_NE(report.error().message.find("no step in common"), std::string::npos) << report.error().message;
}

}  // namespace
}  // namespace tumble::replay
