// What is recorded is what is read, for every kind of input and every mode.
#include <gtest/gtest.h>

#include "replay/log/verify.h"
#include "tests/support/log_memory.h"

namespace tumble::replay {
namespace {

TEST(LogRoundTrip, HeaderComesBack) {
  const sim::SceneDef scene = scene_with_inputs();
  RecordOptions options;
  options.scene_text = "name = \"small\"\n# a comment\n";
  options.overrides = {"world.dt=0.01", "grid.rows=7"};
  options.states = {3};
  const Result<LogReader> log = open_memory(record_to_memory(scene, options));
  ASSERT_TRUE(log.ok()) << log.error().message;
  const LogHeader& header = log->header();
  EXPECT_EQ(header.scene, scene);
  EXPECT_EQ(header.scene_text, options.scene_text);
  EXPECT_EQ(header.overrides, options.overrides);
  EXPECT_EQ(header.states, options.states);
  EXPECT_EQ(header.method, "thesis");
  EXPECT_EQ(header.method_version, sim::method_version(sim::Method::kThesis));
  EXPECT_EQ(header.phases, header_for(scene).phases);
  EXPECT_FALSE(header.phases.empty());
  EXPECT_EQ(header.format_major, kFormatMajor);
  EXPECT_TRUE(log->condition().whole());
}

TEST(LogRoundTrip, EveryInputKindComesBackInItsStep) {
  const sim::SceneDef scene = scene_with_inputs();
  Result<LogReader> log = open_memory(record_to_memory(scene));
  ASSERT_TRUE(log.ok());
  std::vector<sim::TimedCommand> found;
  std::vector<bool> kinds(std::variant_size_v<sim::Command>);
  for (std::uint64_t k = 1; k <= log->step_count(); ++k) {
    const Result<const StepRecord*> step = log->read_hashes(k);
    ASSERT_TRUE(step.ok());
    for (const sim::Command& command : (*step)->inputs) {
      found.push_back({k, command});
      kinds[command.index()] = true;
    }
  }
  EXPECT_EQ(found, scene.inputs);
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) EXPECT_TRUE(kinds[kind]) << "input " << kind;
}

TEST(LogRoundTrip, StatesAreTheSessionsToTheBit) {
  for (const sim::Method method : kMethods) {
    const sim::SceneDef scene = scene_with_inputs(40, method);
    const std::vector<BodyStates> wanted = simulate(scene);
    for (const std::uint64_t flush_every : {1ULL, 2ULL, 7ULL, 1000ULL}) {
      SCOPED_TRACE(std::string(name_of(method)) + ", chunks of " + std::to_string(flush_every));
      Result<LogReader> log = open_memory(record_to_memory(scene, {}, flush_every));
      ASSERT_TRUE(log.ok());
      ASSERT_EQ(log->step_count(), scene.steps);
      for (std::uint64_t k = 0; k <= scene.steps; ++k) {
        const Result<const StepRecord*> step = log->read_step(k);
        ASSERT_TRUE(step.ok()) << step.error().message;
        EXPECT_EQ((*step)->step, k);
        EXPECT_TRUE(same_bits((*step)->states, wanted[k])) << "step " << k;
        EXPECT_EQ((*step)->state_hash, state_hash(wanted[k]));
      }
      EXPECT_TRUE(verify(*log).condition.whole());
    }
  }
}

TEST(LogRoundTrip, StepsComeInAnyOrder) {
  const sim::SceneDef scene = scene_with_inputs();
  const std::vector<BodyStates> wanted = simulate(scene);
  Result<LogReader> log = open_memory(record_to_memory(scene, {}, 6));
  ASSERT_TRUE(log.ok());
  for (const std::uint64_t k : {40ULL, 3ULL, 0ULL, 23ULL, 22ULL, 39ULL, 1ULL, 24ULL}) {
    const Result<const StepRecord*> step = log->read_step(k);
    ASSERT_TRUE(step.ok());
    EXPECT_TRUE(same_bits((*step)->states, wanted[k])) << k;
  }
  EXPECT_FALSE(log->read_step(41).ok());
}

TEST(LogRoundTrip, DtIsThatOfEachStep) {
  Result<LogReader> log = open_memory(record_to_memory(scene_with_inputs()));
  ASSERT_TRUE(log.ok());
  EXPECT_EQ((*log->read_step(4))->dt, 1.0 / 60);
  EXPECT_EQ((*log->read_step(5))->dt, 1.0 / 100);
  EXPECT_EQ((*log->read_step(20))->dt, 1.0 / 100);
  EXPECT_EQ((*log->read_step(21))->dt, 1.0 / 30);
}

TEST(LogRoundTrip, SmallerModesKeepHashesOfAllSteps) {
  const sim::SceneDef scene = scene_with_inputs();
  const std::vector<BodyStates> wanted = simulate(scene);
  for (const std::uint32_t every : {0U, 1U, 4U}) {
    RecordOptions options;
    options.states = {every};
    Result<LogReader> log = open_memory(record_to_memory(scene, options, 9));
    ASSERT_TRUE(log.ok());
    for (std::uint64_t k = 1; k <= scene.steps; ++k) {
      const Result<const StepRecord*> step = log->read_step(k);
      ASSERT_TRUE(step.ok());
      EXPECT_EQ((*step)->has_states, every != 0 && k % every == 0);
      EXPECT_EQ((*step)->state_hash, state_hash(wanted[k]));
      if ((*step)->has_states) {
        EXPECT_TRUE(same_bits((*step)->states, wanted[k])) << k;
      }
    }
    EXPECT_TRUE(verify(*log).condition.whole());
  }
}

TEST(LogRoundTrip, ALogWithoutStepsHoldsStateZero) {
  Result<LogReader> log = open_memory(record_to_memory(small_scene(0)));
  ASSERT_TRUE(log.ok()) << log.error().message;
  EXPECT_EQ(log->step_count(), 0U);
  const Result<const StepRecord*> start = log->read_step(0);
  ASSERT_TRUE(start.ok());
  EXPECT_TRUE(same_bits((*start)->states, simulate(small_scene(0))[0]));
  EXPECT_TRUE(verify(*log).condition.whole());
}

TEST(LogRoundTrip, ASceneWithoutBodiesIsALogToo) {
  sim::SceneDef scene;
  scene.world.method = sim::Method::kThesis;
  scene.steps = 5;
  Result<LogReader> log = open_memory(record_to_memory(scene));
  ASSERT_TRUE(log.ok());
  EXPECT_EQ(log->step_count(), 5U);
  EXPECT_TRUE(verify(*log).condition.whole());
}

TEST(LogRoundTrip, ChainsDependOnTheSessionNotOnTheChunks) {
  const sim::SceneDef scene = scene_with_inputs();
  Result<LogReader> a = open_memory(record_to_memory(scene, {}, 3));
  Result<LogReader> b = open_memory(record_to_memory(scene, {}, 16));
  ASSERT_TRUE(a.ok() && b.ok());
  for (std::uint64_t k = 0; k <= scene.steps; ++k) EXPECT_EQ(*a->chain_at(k), *b->chain_at(k)) << k;
  EXPECT_NE(*a->chain_at(3), *a->chain_at(4));
}

TEST(LogRoundTrip, EqualSessionsGiveEqualBytes) {
  EXPECT_EQ(record_to_memory(scene_with_inputs(), {}, 8), record_to_memory(scene_with_inputs(), {}, 8));
}

/// Bytes of a log over its body-steps, frozen and not.
std::pair<double, double> bytes_per_body_step(const sim::SceneDef& scene) {
  const Bytes bytes = record_to_memory(scene);
  Result<LogReader> log = open_memory(bytes);
  double frozen = 0;
  double moving = 0;
  for (std::uint64_t k = 1; k <= scene.steps; ++k) {
    for (const std::uint8_t flag : (*log->read_step(k))->states.frozen) (flag != 0 ? frozen : moving) += 1;
  }
  return {static_cast<double>(bytes.size()) / frozen, static_cast<double>(bytes.size()) / moving};
}

TEST(LogSize, BodiesThatFallTogetherTakeFewBytes) {
  for (const sim::Method method : kMethods) {
    sim::SceneDef scene;
    scene.world.method = method;
    scene.world.dt = 1.0 / 300;
    scene.steps = 300;
    for (std::uint64_t k = 0; k < 100; ++k) {
      const std::uint64_t row = k / 10;
      sim::BoxDef box;
      box.id = k + 1;
      box.position = {1.25 * static_cast<double>(k % 10), 2 * static_cast<double>(row), 1};
      box.orientation = {0.92387953251128674, 0.38268343236508978, 0, 0};  // on an edge, 45° about x
      scene.boxes.push_back(box);
    }
    EXPECT_LT(bytes_per_body_step(scene).second, 25) << name_of(method);
  }
}

TEST(LogSize, FrozenBodiesTakeNextToNothing) {
  sim::SceneDef scene = small_scene(600);
  scene.boxes.clear();
  for (std::uint64_t k = 0; k < 200; ++k) {
    const std::uint64_t row = k / 20;
    sim::BoxDef box;
    box.id = k + 1;
    box.position = {1.0625 * static_cast<double>(k % 20), 1.5 * static_cast<double>(row), 0.5};
    box.frozen = true;
    scene.boxes.push_back(box);
  }
  EXPECT_LT(bytes_per_body_step(scene).first, 0.5);
}

TEST(StatesMode, WordsAreReadAndWritten) {
  for (const std::string text : {"all", "hashes", "every:2", "every:4294967295"}) {
    const Result<StatesMode> mode = parse_states_mode(text);
    ASSERT_TRUE(mode.ok()) << text;
    EXPECT_EQ(to_string(*mode), text);
  }
  for (const std::string text : {"", "none", "every:", "every:0", "every:-1", "every:1x", "every:4294967296"}) {
    const Result<StatesMode> mode = parse_states_mode(text);
    ASSERT_FALSE(mode.ok()) << text;
    EXPECT_NE(mode.error().message.find("every:N"), std::string::npos);
  }
}

}  // namespace
}  // namespace tumble::replay
