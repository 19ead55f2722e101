// Logs of other engines: what is told is what is read, to the bit; what is forgotten or cannot be is said; and nobody
// takes such a log for one that can be replayed.
#include "tumble/replay/engine_log.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "replay/log/byte_memory.h"
#include "replay/log/verify.h"
#include "replay/measure/measure_log.h"
#include "replay/measure/metric_bound.h"
#include "tests/support/engine_log_in_c.h"
#include "tests/support/log_memory.h"
#include "tumble/replay/compare.h"
#include "tumble/replay/engine_log_c.h"
#include "tumble/replay/player.h"
#include "tumble/replay/replayer.h"

namespace tumble::replay {
namespace {

sim::BoxDef cube(sim::BodyId id, double z) {
  sim::BoxDef box;
  box.id = id;
  box.position = {0.1, 0, z};  // not on the grid of our positions
  return box;
}

EngineState placed(const sim::Vec3& position, const sim::Vec3& velocity = {0, 0, 0}, bool frozen = false) {
  EngineState state;
  state.position = position;
  state.velocity = velocity;
  state.frozen = frozen;
  return state;
}

sim::SceneDef start_of(std::vector<sim::BoxDef> boxes) {
  sim::SceneDef scene;
  scene.name = "drop";
  scene.boxes = std::move(boxes);
  scene.steps = 0;
  return scene;
}

/// An engine's log in memory.
struct Engine {
  explicit Engine(const sim::SceneDef& start, const EngineDef& def = {{"toy", "1"}}) {
    auto made = EngineLog::create(std::make_unique<MemoryByteSink>(file, "toy.tumble"), def, start);
    EXPECT_TRUE(made.ok()) << made.error().message;
    log = *std::move(made);
  }

  LogReader read() {
    EXPECT_TRUE(log->finish().ok());
    Result<LogReader> reader = LogReader::open(std::make_unique<MemoryByteSource>(file, "toy.tumble"));
    EXPECT_TRUE(reader.ok()) << reader.error().message;
    return *std::move(reader);
  }

  MemoryFile file = std::make_shared<std::vector<std::byte>>();
  std::unique_ptr<EngineLog> log;
};

/// A cube that goes down by `speed` a second, `steps` steps of 0.1 s.
LogReader falling(const EngineName& name, double speed, std::uint64_t steps, double nudge = 0) {
  Engine engine(start_of({cube(1, 5)}), {name});
  for (std::uint64_t k = 1; k <= steps; ++k) {
    EngineState state;
    state.position = {0.1, k > 2 ? nudge : 0.0, 5 - speed * 0.1 * static_cast<double>(k)};
    state.velocity = {0, 0, -speed};
    EXPECT_TRUE(engine.log->set_state(1, state).ok());
    EXPECT_TRUE(engine.log->end_step(0.1).ok());
  }
  return engine.read();
}

TEST(EngineLog, KeepsWhatItIsToldToTheBit) {
  Engine engine(start_of({cube(1, 5), cube(2, 7)}));
  EngineState odd;
  odd.position = {0.1F, std::nan(""), 1e300};  // no world of ours would hold these
  odd.orientation = {0.999F, 0.01, 0, -0.0};
  odd.velocity = {5e-324, -0.0, std::numeric_limits<double>::infinity()};
  ASSERT_TRUE(engine.log->set_state(1, odd).ok());
  ASSERT_TRUE(engine.log->set_state(2, placed({1, 2, 3}, {0, 0, 0}, true)).ok());
  ASSERT_TRUE(engine.log->end_step(0.25).ok());
  LogReader log = engine.read();
  EXPECT_TRUE(verify(log).condition.whole());
  EXPECT_EQ(to_string(*log.header().engine), "toy 1");
  ASSERT_EQ((*log.read_step(0))->states.position[0], sim::Vec3(0.1, 0, 5));
  const Result<const StepRecord*> step = log.read_step(1);
  ASSERT_TRUE(step.ok()) << step.error().message;
  BodyStates wanted;
  wanted.id = {1, 2};
  for (const EngineState& state : {odd, placed({1, 2, 3}, {0, 0, 0}, true)}) {
    wanted.position.push_back(state.position);
    wanted.orientation.insert(wanted.orientation.size(), state.orientation);
    wanted.velocity.push_back(state.velocity);
    wanted.spin.push_back(state.spin);
    wanted.frozen.push_back(state.frozen ? 1 : 0);
  }
  EXPECT_TRUE(same_bits((*step)->states, wanted));
  EXPECT_EQ((*step)->dt, 0.25);
}

TEST(EngineLog, BodyWithoutAStateIsNamed) {
  Engine engine(start_of({cube(1, 5), cube(2, 7)}));
  ASSERT_TRUE(engine.log->set_state(1, {}).ok());
  const Status ended = engine.log->end_step(0.1);
  ASSERT_FALSE(ended.ok());
  EXPECT_NE(ended.error().message.find("step 1: found no state of body 2"), std::string::npos) << ended.error().message;
}

TEST(EngineLog, RestingAndStaticBodiesNeedNoState) {
  sim::BoxDef resting = cube(1, 0.5), fixed = cube(2, 9);
  resting.frozen = true;
  fixed.is_static = true;
  Engine engine(start_of({resting, fixed}));
  ASSERT_TRUE(engine.log->end_step(0.1).ok());
  EXPECT_EQ(engine.read().last_step(), 1U);
}

TEST(EngineLog, WhatCannotBeIsRefused) {
  Engine engine(start_of({cube(1, 5)}));
  EXPECT_FALSE(engine.log->set_state(7, {}).ok());
  EXPECT_FALSE(engine.log->input(sim::Remove{7}).ok());
  EXPECT_FALSE(engine.log->set_phase_hashes(std::array<std::uint64_t, 1>{1}).ok()) << "it has no phases";
  ASSERT_TRUE(engine.log->set_state(1, {}).ok());
  EXPECT_FALSE(engine.log->input(sim::Wake{1}).ok()) << "inputs come before states";
  EXPECT_FALSE(engine.log->end_step(0).ok());
  EXPECT_FALSE(engine.log->finish().ok()) << "a step was begun";
  const auto nameless = EngineLog::create(std::make_unique<MemoryByteSink>(engine.file, "x"), {}, start_of({}));
  EXPECT_FALSE(nameless.ok());
}

TEST(EngineLog, InputsAreLoggedAndTheirEnergyCounted) {
  Engine engine(start_of({cube(1, 5)}));
  sim::BoxDef thrown = cube(3, 2);
  thrown.velocity = {4, 0, 0};
  ASSERT_TRUE(engine.log->input(sim::Throw{thrown}).ok());
  ASSERT_TRUE(engine.log->set_state(1, placed({0, 0, 5})).ok());
  ASSERT_TRUE(engine.log->set_state(3, placed({0.4, 0, 2}, {4, 0, 0})).ok());
  ASSERT_TRUE(engine.log->end_step(0.1).ok());
  ASSERT_TRUE(engine.log->input(sim::Remove{1}).ok());
  ASSERT_TRUE(engine.log->set_state(3, placed({0.8, 0, 2}, {4, 0, 0})).ok());
  ASSERT_TRUE(engine.log->end_step(0.1).ok());
  LogReader log = engine.read();
  const StepRecord first = **log.read_step(1);
  ASSERT_EQ(first.inputs.size(), 1U);
  EXPECT_NEAR(first.counters.inputs, 0.5 * 16 + 9.81 * 2, 1e-9);
  EXPECT_NEAR(first.counters.kinetic, 8, 1e-12);
  EXPECT_EQ((*log.read_step(2))->states.id, std::vector<sim::BodyId>{3});
  const Result<Metrics> metrics = measure_log(log);
  ASSERT_TRUE(metrics.ok()) << metrics.error().message;
  EXPECT_EQ(metrics->bodies, 2U);
}

// No recorder tells it, so a bound on it would hold for every session.
TEST(EngineLog, DissipationIsNotToldAndNotZero) {
  LogReader log = falling({"toy", "1"}, 1, 5);
  std::optional<double> in_row = 0;
  const Result<Metrics> metrics = measure_log(log, {}, [&](const SeriesRow& row) { in_row = row.removed; });
  ASSERT_TRUE(metrics.ok()) << metrics.error().message;
  EXPECT_LT(metrics->energy.final, metrics->energy.initial - 1);
  EXPECT_EQ(metrics->energy.removed, std::nullopt);
  EXPECT_EQ(in_row, std::nullopt);
  const MetricBound bound = *parse_metric_bound("removed<=0");
  EXPECT_FALSE(bound.holds(bound.metric->value(*metrics)));
}

TEST(EngineLog, CannotBeReplayedOnlyCompared) {
  LogReader log = falling({"toy", "1"}, 1, 5);
  const Result<ReplayReport> replayed = replay_log(log);
  ASSERT_FALSE(replayed.ok());
  EXPECT_EQ(replayed.error().kind, ErrorKind::kBadInput);
  EXPECT_NE(replayed.error().message.find("this log was written by toy 1; it cannot be replayed, only compared"),
            std::string::npos)
      << replayed.error().message;
  EXPECT_FALSE(Player::at(log, 0).ok());
}

TEST(EngineLog, DiffOfTwoVersionsNamesBodyAndField) {
  LogReader a = falling({"toy", "1"}, 1, 5);
  LogReader same = falling({"toy", "2"}, 1, 5);
  LogReader b = falling({"toy", "2"}, 1, 5, 1e-9);
  const Result<DiffReport> equal = diff_logs(a, same);
  ASSERT_TRUE(equal.ok());
  EXPECT_TRUE(equal->identical()) << describe(*equal->first);
  const Result<DiffReport> report = diff_logs(a, b);
  ASSERT_TRUE(report.ok());
  ASSERT_TRUE(report->first.has_value());
  EXPECT_EQ(report->first->step, 3U);
  EXPECT_EQ(report->first->body, 1U);
  EXPECT_EQ(report->first->field, "position.y");
}

TEST(EngineLog, UlpsAreCountedInTheEnginesPrecision) {
  const EngineName single = {"toy", "1", kBinary32Bits};
  const double nudge = std::nextafter(1.0F, 2.0F);
  LogReader a = falling(single, 1, 5, 1.0);
  LogReader b = falling(single, 1, 5, nudge);
  const Result<DiffReport> report = diff_logs(a, b);
  ASSERT_TRUE(report.ok());
  EXPECT_EQ(report->first->ulps, 1U);
  LogReader c = falling({"toy", "1"}, 1, 5, 1.0);
  LogReader d = falling({"toy", "1"}, 1, 5, nudge);
  EXPECT_EQ(diff_logs(c, d)->first->ulps, std::uint64_t{1} << 29U);
  EXPECT_EQ(ulps32_between(-0.0, 0.0), 1U);
  EXPECT_EQ(ulps32_between(1e-45, -1e-45), 3U);
  EXPECT_EQ(ulps32_between(0.12, 0.12), 0U);
  EXPECT_EQ(ulps32_between(1, std::nextafter(1.0, 2.0)), 1U) << "two numbers that differ are not 0 apart";
  EXPECT_FALSE(ulps32_between(1e300, 1).has_value());
  EXPECT_FALSE(ulps32_between(std::nan(""), 1).has_value());
}

TEST(EngineLog, AgainstOurOwnLogOnlyStatesAreCompared) {
  const sim::SceneDef scene = small_scene(10);
  Result<LogReader> ours = open_memory(record_to_memory(scene));
  ASSERT_TRUE(ours.ok());
  for (const bool nudged : {false, true}) {
    Engine engine((*ours).header().scene);
    const std::vector<BodyStates> states = simulate(scene);
    for (std::size_t k = 1; k < states.size(); ++k) {
      for (std::size_t i = 0; i < states[k].size(); ++i) {
        EngineState state = {states[k].position[i], states[k].orientation[i], states[k].velocity[i], states[k].spin[i],
                             states[k].frozen[i] != 0};
        if (nudged && k == 6 && i == 1) state.spin.x() += 1e-3;
        ASSERT_TRUE(engine.log->set_state(states[k].id[i], state).ok());
      }
      ASSERT_TRUE(engine.log->end_step(scene.world.dt).ok());
    }
    LogReader theirs = engine.read();
    const Result<DiffReport> report = diff_logs(*ours, theirs);
    ASSERT_TRUE(report.ok()) << report.error().message;
    EXPECT_EQ(report->identical(), !nudged) << (report->first ? describe(*report->first) : "");
    if (nudged) {
      EXPECT_EQ(report->first->step, 6U);
    }
  }
}

TEST(EngineLog, CWritesTheSame) {
  const std::string path = ::testing::TempDir() + "engine_log_in_c.tumble";
  std::array<char, 300> message{};
  ASSERT_EQ(write_log_in_c(path.c_str(), message.data(), message.size()), 0) << message.data();
  Result<LogReader> log = LogReader::open(path);
  ASSERT_TRUE(log.ok()) << log.error().message;
  EXPECT_TRUE(verify(*log).condition.whole());
  EXPECT_EQ(to_string(*log->header().engine), "C engine 0.1");
  EXPECT_EQ(log->header().engine->precision_bits, kBinary32Bits);
  EXPECT_EQ(log->header().phases, (std::vector<std::string>{"collide", "solve"}));
  const StepRecord last = **log->read_step(3);
  EXPECT_EQ(last.phase_words, (std::vector<std::uint64_t>{7, 8}));
  EXPECT_EQ(last.states.id, (std::vector<sim::BodyId>{1, 9}));
  EXPECT_EQ(last.states.position[0], sim::Vec3(0, 0, 3.5));
  EXPECT_EQ(last.states.frozen, (std::vector<std::uint8_t>{0, 1}));
  std::remove(path.c_str());
}

TEST(EngineLog, CSaysWhatWentWrongFirst) {
  std::array<char, 300> message{};
  EXPECT_EQ(misuse_log_in_c(message.data(), message.size()), 2);
  EXPECT_NE(std::string(message.data()).find("wanted tumble_log_begin() before"), std::string::npos) << message.data();
}

// 256 is 0 in eight bits.
TEST(EngineLogInC, RefusesAChannelOfNoKind) {
  char message[200];
  for (const auto& [kind, scope] : {std::pair(7, 1), std::pair(256, 1), std::pair(2, 3), std::pair(2, 256)}) {
    EXPECT_EQ(add_channel_in_c(kind, scope, message, sizeof message), static_cast<int>(TUMBLE_BAD_INPUT))
        << kind << ", " << scope;
    EXPECT_NE(std::string(message).find("channel \"joint\": found kind"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace tumble::replay
