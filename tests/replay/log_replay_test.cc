// Replay and diff: identical sessions are, and one changed value anywhere is not.
#include <gtest/gtest.h>

#include <cmath>
#include <span>

#include "replay/diff/compare.h"
#include "replay/diff/input_difference.h"
#include "replay/diff/replayer.h"
#include "replay/format/limits.h"
#include "replay/log/log_writer.h"
#include "tests/support/log_memory.h"

namespace tumble::replay {
namespace {

/// Records a session whose log lies from step `lie` on: `change` alters what is written, not what happens.
template <class Change>
Bytes record_with_lie(const sim::SceneDef& scene, std::uint64_t lie, Change change) {
  const auto disk = std::make_shared<Disk>();
  Result<sim::World> world = sim::create_world(scene);
  auto writer = LogWriter::create(std::make_unique<MemorySink>(disk), header_for(scene), world->state());
  sim::PhaseHashes hashes;
  for (std::uint64_t k = 1; k <= scene.steps; ++k) {
    hashes.clear();
    Result<sim::StepCounters> counters = sim::step(*world, &hashes);
    EXPECT_TRUE(counters.ok());
    std::vector<std::uint64_t> words = hashes.words();
    sim::WorldState state = world->state();
    if (k == lie) change(state, words, *counters);
    EXPECT_TRUE((*writer)->append({state.def.dt, {}, words, *counters}, state).ok());
  }
  EXPECT_TRUE((*writer)->finish().ok());
  return disk->bytes;
}

using Words = std::vector<std::uint64_t>;

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
  EXPECT_EQ(report.first->field, "continuation_hash");
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

DiffReport diff_of(const Bytes& bytes_a, const Bytes& bytes_b, const Tolerances& tolerances = {}) {
  Result<LogReader> a = open_memory(bytes_a);
  Result<LogReader> b = open_memory(bytes_b);
  EXPECT_TRUE(a.ok() && b.ok());
  Result<DiffReport> report = diff_logs(*a, *b, tolerances);
  EXPECT_TRUE(report.ok()) << report.error().message;
  return *std::move(report);
}

TEST(Diff, LogsOfOneSessionAreIdenticalWhateverTheirChunks) {
  const DiffReport report =
      diff_of(record_to_memory(scene_with_inputs(), {}, 3), record_to_memory(scene_with_inputs(), {}, 16));
  EXPECT_TRUE(report.identical());
  EXPECT_EQ(report.steps, 40U);
  EXPECT_TRUE(report.headers.empty());
}

TEST(Diff, TheFirstDifferentStepIsFoundInAnyChunk) {
  const sim::SceneDef scene = small_scene(200);
  const Bytes truth = record_to_memory(scene);
  for (const std::uint64_t lie : {1ULL, 63ULL, 64ULL, 65ULL, 130ULL, 200ULL}) {
    const Bytes bytes = record_with_lie(scene, lie, [](sim::WorldState& state, Words&, sim::StepCounters&) {
      state.bodies.position.z[2] += 1.0 / 1024;
    });
    const DiffReport report = diff_of(truth, bytes);
    ASSERT_TRUE(report.first.has_value()) << lie;
    EXPECT_EQ(report.first->step, lie);
    EXPECT_EQ(report.first->body, 12U);
    EXPECT_EQ(report.first->field, "position.z");
    Tolerances tolerances;
    tolerances.position = 1.0 / 512;
    EXPECT_TRUE(diff_of(truth, bytes, tolerances).identical()) << lie;
    tolerances.position = 1.0 / 2048;
    EXPECT_FALSE(diff_of(truth, bytes, tolerances).identical()) << lie;
  }
}

TEST(Diff, ALongerLogIsNotIdentical) {
  const DiffReport report = diff_of(record_to_memory(small_scene(20)), record_to_memory(small_scene(19)));
  EXPECT_FALSE(report.first.has_value());
  EXPECT_FALSE(report.identical());
  EXPECT_EQ(report.steps, 19U);
  EXPECT_EQ(report.headers.size(), 1U);
}

TEST(Diff, AnotherInputIsFoundBeforeItsStep) {
  sim::SceneDef other = scene_with_inputs();
  other.inputs[1].command = sim::Push{11, {1, 0, 3}, true, {0, 0, 0}};
  const DiffReport report = diff_of(record_to_memory(scene_with_inputs()), record_to_memory(other));
  ASSERT_TRUE(report.first.has_value());
  EXPECT_EQ(report.first->step, 3U);
  EXPECT_EQ(report.first->phase, "inputs");
  EXPECT_EQ(report.first->field, "push.impulse.z");
  EXPECT_EQ(report.first->body, 11U);
  EXPECT_EQ(std::get<double>(report.first->expected), 2);
  EXPECT_EQ(std::get<double>(report.first->actual), 3);
}

std::optional<InputDifference> input_difference(const sim::Command& a, const sim::Command& b) {
  return first_difference(std::span(&a, 1), std::span(&b, 1));
}

TEST(InputDifference, NamesTheFieldOfEachKindOfInput) {
  sim::BoxDef box, heavier, other_look;
  box.id = heavier.id = other_look.id = 3;
  heavier.mass = 2;
  other_look.material.texture = sim::Texture::kBrick;
  EXPECT_EQ(input_difference(sim::Throw{box}, sim::Throw{heavier})->field, "throw.mass");
  EXPECT_FALSE(input_difference(sim::Throw{box}, sim::Throw{other_look})) << "look changes nothing";
  EXPECT_EQ(input_difference(sim::Remove{3}, sim::Remove{4})->field, "remove.id");
  EXPECT_FALSE(input_difference(sim::Remove{3}, sim::Remove{4})->body);
  EXPECT_EQ(input_difference(sim::Wake{3}, sim::Wake{5})->field, "wake.id");
  EXPECT_EQ(
      input_difference(sim::SetVelocity{3, {1, 2, 3}, {0, 0, 0}}, sim::SetVelocity{3, {1, 2, 3}, {0, 0.5, 0}})->field,
      "set_velocity.spin.y");
  EXPECT_EQ(input_difference(sim::SetGravity{{0, 0, -9}}, sim::SetGravity{{0, 0, -8}})->field, "set_gravity.gravity.z");
  EXPECT_EQ(input_difference(sim::SetDt{0.1}, sim::SetDt{0.2})->field, "set_dt.dt");
  const sim::Push centre{3, {1, 0, 0}, true, {0, 0, 0}}, point{3, {1, 0, 0}, false, {0, 0, 1}};
  EXPECT_EQ(input_difference(centre, point)->field, "push.at_centre");
  EXPECT_FALSE(input_difference(centre, sim::Push{3, {1, 0, 0}, true, {9, 9, 9}})) << "a point that is not read";
  const auto kinds = input_difference(sim::Wake{3}, sim::Remove{3});
  EXPECT_EQ(kinds->field, "inputs");
  EXPECT_EQ(std::get<std::string>(kinds->expected), "wake");
  EXPECT_EQ(std::get<std::string>(kinds->actual), "remove");
  EXPECT_TRUE(input_difference(sim::SetDt{0.0}, sim::SetDt{-0.0})) << "to the bit";
}

TEST(Diff, BodiesOfOneLogOnlyAreNamed) {
  sim::SceneDef other = small_scene();
  other.boxes.pop_back();
  const DiffReport report = diff_of(record_to_memory(small_scene()), record_to_memory(other));
  ASSERT_TRUE(report.first.has_value());
  EXPECT_EQ(report.first->step, 0U);
  EXPECT_EQ(report.first->field, "id");
  EXPECT_EQ(report.first->body, 12U);
}

TEST(Diff, TolerancesNeedStates) {
  sim::SceneDef other = small_scene();
  other.boxes[2].velocity = {0, 0, 1};
  RecordOptions hashes_only;
  hashes_only.states = {0};
  Result<LogReader> a = open_memory(record_to_memory(small_scene(), hashes_only));
  Result<LogReader> b = open_memory(record_to_memory(other, hashes_only));
  Tolerances tolerances;
  tolerances.velocity = 2;
  const Result<DiffReport> report = diff_logs(*a, *b, tolerances);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().kind, ErrorKind::kBadInput);
}

TEST(Divergence, NaNsAreComparedByTheirBits) {
  BodyStates a = simulate(small_scene(0))[0];
  a.spin.x[1] = std::nan("1");
  BodyStates b = a;
  EXPECT_FALSE(first_difference(a, b).has_value());
  b.spin.x[1] = std::nan("2");
  const std::optional<Divergence> found = first_difference(a, b);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->field, "spin.x");
  EXPECT_FALSE(found->ulps.has_value());
}

TEST(Divergence, UlpsCountDoublesBetween) {
  EXPECT_EQ(ulps_between(1.0, 1.0), 0U);
  EXPECT_EQ(ulps_between(1.0, std::nextafter(1.0, 2.0)), 1U);
  EXPECT_EQ(ulps_between(-0.0, 0.0), 1U);
  EXPECT_EQ(ulps_between(5e-324, -5e-324), 3U);
  EXPECT_FALSE(ulps_between(std::nan(""), 1).has_value());
}

}  // namespace
}  // namespace tumble::replay
