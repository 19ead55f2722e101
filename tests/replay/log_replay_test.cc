// Replay: a session that is replayed is identical, and one changed value anywhere is found.
#include <gtest/gtest.h>

#include "tests/replay/lying_log.h"
#include "tests/support/log_memory.h"
#include "tumble/replay/player.h"
#include "tumble/replay/replayer.h"

namespace tumble::replay {
namespace {

ReplayReport replay_of(const Bytes& bytes, const ReplayOptions& options = {}) {
  Result<LogReader> log = open_memory(bytes);
  EXPECT_TRUE(log.ok());
  Result<ReplayReport> report = replay_log(*log, options);
  EXPECT_TRUE(report.ok()) << report.error().message;
  return *std::move(report);
}

TEST(Replay, ASessionReplaysToTheBit) {
  for (const sim::Method method : kMethods) {
    const sim::SceneDef scene = scene_with_inputs(40, method);
    for (const std::uint64_t flush_every : {5ULL, 1000ULL}) {
      const ReplayReport report = replay_of(record_to_memory(scene, {}, flush_every));
      EXPECT_TRUE(report.identical()) << describe(*report.first);
      EXPECT_EQ(report.steps, 40U);
      EXPECT_TRUE(report.notes.empty());
      EXPECT_EQ(report.final_hash, state_hash(simulate(scene).back()));
    }
  }
}

TEST(Replay, AValueChangedInAnyStepIsFoundThere) {
  const sim::SceneDef scene = small_scene();
  for (std::uint64_t lie = 1; lie <= scene.steps; ++lie) {
    const Bytes bytes = record_with_lie(scene, lie, [](sim::WorldState& state, Words&, sim::StepCounters&) {
      double& y = state.bodies.velocity.y[1];
      y = std::nextafter(y, 100.0);
    });
    const ReplayReport report = replay_of(bytes);
    ASSERT_FALSE(report.identical()) << "step " << lie;
    EXPECT_EQ(report.first->step, lie);
    EXPECT_EQ(report.first->body, 11U);
    EXPECT_EQ(report.first->field, "velocity.y");
    EXPECT_EQ(report.first->ulps, 1U);
  }
}

TEST(Replay, AnotherPhaseHashNamesPhaseAndSubstep) {
  const sim::SceneDef scene = small_scene();
  const std::size_t phases = header_for(scene).phases.size();
  for (const std::size_t word : {std::size_t{0}, phases - 1}) {
    const Bytes bytes = record_with_lie(scene, scene.steps, [&](sim::WorldState&, Words& words, sim::StepCounters&) {
      ASSERT_GT(words.size(), word);
      words[word] ^= 1;
    });
    const ReplayReport report = replay_of(bytes);
    ASSERT_FALSE(report.identical());
    EXPECT_EQ(report.first->step, scene.steps);
    EXPECT_EQ(report.first->phase, header_for(scene).phases[word]);
    EXPECT_EQ(report.first->substep, 0U);
    EXPECT_EQ(report.first->field, "phase_hash");
    EXPECT_FALSE(report.first->body.has_value());
  }
}

TEST(Replay, AnotherCounterIsFound) {
  const Bytes bytes = record_with_lie(
      small_scene(), 7, [](sim::WorldState&, Words&, sim::StepCounters& counters) { counters.removed += 0.5; });
  const ReplayReport report = replay_of(bytes);
  ASSERT_FALSE(report.identical());
  EXPECT_EQ(report.first->step, 7U);
  EXPECT_EQ(report.first->field, "removed_energy");
}

TEST(Replay, HiddenStateOfAKeyframeIsCompared) {
  const sim::SceneDef scene = small_scene(300);
  const Result<LogReader> truth = open_memory(record_to_memory(scene));
  ASSERT_TRUE(truth.ok());
  ASSERT_GE(truth->chunks().size(), 2U);
  const std::uint64_t end = truth->chunks()[1].first_step - 1;
  const Bytes bytes = record_with_lie(scene, end, [](sim::WorldState& state, Words&, sim::StepCounters&) {
    state.bodies.low_energy_time[2] += 0.125;  // which no hash of the step covers
  });
  const ReplayReport report = replay_of(bytes);
  ASSERT_FALSE(report.identical());
  EXPECT_EQ(report.first->step, end);
  EXPECT_EQ(report.first->field, "low_energy_time");
  EXPECT_EQ(report.first->body, 12U);
}

TEST(Replay, ASceneThatResolvesToAnotherStartIsFound) {
  const sim::SceneDef scene = small_scene();
  sim::SceneDef moved = scene;
  moved.boxes[2].position.x() += 0.125;
  const auto disk = std::make_shared<Disk>();
  const Result<sim::World> world = sim::create_world(scene);
  auto writer = LogWriter::create(std::make_unique<MemorySink>(disk), header_for(moved), world->state());
  ASSERT_TRUE((*writer)->finish().ok());
  const ReplayReport report = replay_of(disk->bytes);
  ASSERT_FALSE(report.identical());
  EXPECT_EQ(report.first->step, 0U);
  EXPECT_EQ(report.first->phase, "start");
  EXPECT_EQ(report.first->body, 12U);
  EXPECT_EQ(report.first->field, "position.x");
}

TEST(Replay, SmallerLogsAreComparedByTheirHashes) {
  RecordOptions options;
  options.states = {0};
  const ReplayReport report = replay_of(record_to_memory(scene_with_inputs(), options, 11));
  EXPECT_TRUE(report.identical());
  EXPECT_EQ(report.steps, 40U);
}

TEST(Replay, ATornLogIsComparedAsFarAsItGoesAndSaysSo) {
  Bytes bytes = record_to_memory(small_scene(), {}, 5);
  bytes.resize(bytes.size() - kFooterBytes - 1);
  const ReplayReport report = replay_of(bytes);
  EXPECT_TRUE(report.identical());
  EXPECT_EQ(report.steps, 20U);
  ASSERT_EQ(report.notes.size(), 1U);
  EXPECT_NE(report.notes[0].find("torn"), std::string::npos);
}

void expect_same_from_any_step(const sim::SceneDef& scene) {
  const std::vector<BodyStates> wanted = simulate(scene);
  Result<LogReader> log = open_memory(record_to_memory(scene, {}, 6));
  ASSERT_TRUE(log.ok());
  for (std::uint64_t start = 0; start <= scene.steps; ++start) {
    Result<Player> player = Player::at(*log, start);
    ASSERT_TRUE(player.ok()) << player.error().message;
    ASSERT_EQ(player->world().state().step, start);
    for (std::uint64_t k = start + 1; k <= scene.steps; ++k) {
      const Result<const StepRecord*> step = player->step();
      ASSERT_TRUE(step.ok()) << step.error().message;
      ASSERT_TRUE(same_bits((*step)->states, wanted[k])) << "from " << start << ", step " << k;
    }
    EXPECT_FALSE(player->step().ok());
    Result<ReplayReport> report = replay_log(*log, {start});
    ASSERT_TRUE(report.ok());
    EXPECT_TRUE(report->identical());
    EXPECT_EQ(report->steps, scene.steps - start);
  }
}

TEST(Player, GoingOnFromAnyStepGivesTheSameBits) {
  for (const sim::Method method : kMethods) {
    SCOPED_TRACE(name_of(method));
    expect_same_from_any_step(scene_with_inputs(40, method));
  }
}

}  // namespace
}  // namespace tumble::replay
