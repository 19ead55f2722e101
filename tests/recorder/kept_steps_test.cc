// Whatever a recorder takes, import keeps: every step, every state as it was told, and who sleeps.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "tests/recorder/imported.h"
#include "tests/recorder/recorded.h"

namespace tumble::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<double, 9> kOdd = {0, -0.0, 1, -3, 1e-300, 9000, 1e13, kNan, -INFINITY};

/// An engine that does anything which the recorder does not refuse.
class AnyEngine {
 public:
  using States = std::map<std::uint64_t, TumbleRecState>;

  AnyEngine(std::uint32_t seed, bool in_ring) : random_(seed), in_ring_(in_ring) {}

  StreamBytes run(int steps) {
    StreamBytes bytes;
    TumbleRecDef def = small_def(bytes);
    def.rollback_steps = 3;
    def.phases = "find,solve";
    if (in_ring_) def.ring_s = 1, def.write = nullptr, def.rollback_steps = 0;
    rec_ = tumble_rec_create(&def);
    for (int k = 0; k < 4; ++k) add_body();
    for (int k = 0; k < steps; ++k) {
      if (!in_ring_ && one_in(12)) rewind();
      for (auto n = below(4); n > 0; --n) input();
      step();
    }
    if (in_ring_) {
      EXPECT_EQ(tumble_rec_dump_to(rec_, append, &bytes), TUMBLE_REC_OK);
    }
    EXPECT_EQ(tumble_rec_finish(rec_), TUMBLE_REC_OK) << tumble_rec_message(rec_);
    tumble_rec_close(rec_);
    return bytes;
  }

  /// By step, of the bodies that moved in it.
  [[nodiscard]] const std::map<std::uint64_t, States>& told() const { return told_; }

 private:
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_()) % n; }
  bool one_in(std::size_t n) { return below(n) == 0; }
  double number() { return one_in(3) ? kOdd[below(kOdd.size())] : static_cast<double>(below(64)) / 8 - 4; }
  void take(TumbleRecStatus status) { ASSERT_EQ(status, TUMBLE_REC_OK) << tumble_rec_message(rec_); }

  TumbleRecState any_state() {
    TumbleRecState state = {};
    for (double* three : {state.position, state.velocity, state.spin}) {
      for (int k = 0; k < 3; ++k) three[k] = number();
    }
    state.orientation[0] = 1;
    if (one_in(8)) state.orientation[below(4)] = number();
    if (one_in(16)) state.orientation[0] = 1.02;
    state.asleep = one_in(3) ? 1 : 0;
    return state;
  }

  void add_body() {
    TumbleRecBody body = small_cube(++last_id_);
    body.is_static = one_in(4) ? 1 : 0;
    if (one_in(3)) body.shape = static_cast<TumbleRecShape>(below(6));
    if (one_in(4)) body.mass = number(), body.size[below(3)] = number(), body.friction = number();
    if (!one_in(3)) body.state = any_state();
    take(tumble_rec_body(rec_, &body));
    bodies_[body.id] = {body.state, body.is_static != 0};
  }

  std::uint64_t any_body() {
    auto body = bodies_.begin();
    std::advance(body, below(bodies_.size()));
    return body->first;
  }

  void input() {
    const double u[3] = {number(), number(), number()}, v[3] = {number(), number(), number()};
    const std::size_t kind = bodies_.empty() ? 0 : below(6);
    if (kind == 0) return add_body();
    const std::uint64_t id = any_body();
    if (kind == 1) take(tumble_rec_remove(rec_, id)), bodies_.erase(id);
    if (kind == 2) take(tumble_rec_push(rec_, id, u)), bodies_[id].state.asleep = 0;
    if (kind == 3) take(tumble_rec_set_velocity(rec_, id, u, v)), bodies_[id].state.asleep = 0;
    if (kind == 4) take(tumble_rec_set_gravity(rec_, u));  // wakes nobody
    if (kind == 5) take(tumble_rec_input(rec_, "steer", one_in(2) ? 0 : id, u, sizeof u));
  }

  void step() {
    take(tumble_rec_step_begin(rec_, 0.0625));
    for (auto& [id, body] : bodies_) {
      const bool needs = !body.is_static && body.state.asleep == 0;
      if (!needs && !one_in(4)) continue;
      if (!one_in(5)) body.state = any_state();
      take(tumble_rec_state(rec_, id, &body.state));
    }
    contacts();
    if (one_in(2)) take(tumble_rec_phase_hash(rec_, 1, random_()));
    if (one_in(4)) take(tumble_rec_note(rec_, "a note"));
    take(tumble_rec_step_end(rec_));
    before_[tumble_rec_step(rec_)] = bodies_;
    States& told = told_[tumble_rec_step(rec_)];
    told.clear();
    for (const auto& [id, body] : bodies_) {
      told[id] = body.state;
      if (body.is_static) told[id].asleep = 0;
    }
  }

  void contacts() {
    TumbleRecPoint point = {};
    for (double& number_of : point.position) number_of = number();
    for (auto n = below(3); n > 0 && !bodies_.empty(); --n) {
      TumbleRecContact contact = {};
      contact.a = any_body(), contact.b = one_in(2) ? 0 : any_body();
      contact.part = static_cast<std::uint32_t>(below(2));
      contact.normal[below(3)] = number();
      contact.points = &point, contact.point_count = static_cast<std::uint32_t>(below(2));
      if (contact.a != contact.b) take(tumble_rec_contact(rec_, &contact));
    }
  }

  void rewind() {
    const std::uint64_t last = tumble_rec_step(rec_), to = last - std::min<std::uint64_t>(last, below(4));
    if (to == 0) return;
    take(tumble_rec_rewind(rec_, to));
    told_.erase(told_.upper_bound(to), told_.end());
    bodies_ = before_.at(to);
    for (auto& [id, body] : bodies_) body.state.asleep = 0;  // every body tells its state again
  }

  struct Body {
    TumbleRecState state = {};
    bool is_static = false;
  };

  std::mt19937 random_;
  bool in_ring_;
  TumbleRec* rec_ = nullptr;
  std::uint64_t last_id_ = 0;
  std::map<std::uint64_t, Body> bodies_;
  std::map<std::uint64_t, std::map<std::uint64_t, Body>> before_;  // by step
  std::map<std::uint64_t, States> told_;
};

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

void expect_state(const replay::BodyStates& states, std::size_t row, const TumbleRecState& told) {
  EXPECT_EQ(states.frozen[row] != 0, told.asleep != 0);
  for (int k = 0; k < 3; ++k) {
    EXPECT_TRUE(same_bits(states.position[row][k], told.position[k]));
    EXPECT_TRUE(same_bits(states.velocity[row][k], told.velocity[k]));
    EXPECT_TRUE(same_bits(states.spin[row][k], told.spin[k]));
  }
}

void expect_all_kept(std::uint32_t seed, bool in_ring) {
  SCOPED_TRACE("seed " + std::to_string(seed) + (in_ring ? ", in a ring" : ""));
  AnyEngine engine(seed, in_ring);
  StreamBytes bytes = engine.run(40);
  Result<Imported> got = import_bytes(std::move(bytes));
  ASSERT_TRUE(got.ok()) << got.error().message;
  ASSERT_EQ(got->import.refused, "");
  ASSERT_EQ(got->log.last_step(), engine.told().rbegin()->first);
  for (const auto& [k, states] : engine.told()) {
    if (k <= got->log.first_state()) continue;
    SCOPED_TRACE("step " + std::to_string(k));
    const Result<const replay::StepRecord*> step = got->log.read_step(k);
    ASSERT_TRUE(step.ok()) << step.error().message;
    ASSERT_EQ((*step)->states.size(), states.size());
    std::size_t row = 0;
    for (const auto& [id, told] : states) {
      SCOPED_TRACE("body " + std::to_string(id));
      ASSERT_EQ((*step)->states.id[row], id);
      expect_state((*step)->states, row++, told);
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST(KeptSteps, WhateverTheRecorderTakes) {
  for (std::uint32_t seed = 1; seed <= 300 && !testing::Test::HasFailure(); ++seed)
    expect_all_kept(seed, seed % 5 == 0);
}

// Gravity woke the sleepers of the log's own world, and the session ended there.
TEST(KeptSteps, GravityWakesNobody) {
  Result<Imported> got = import_bytes(record(2, 4, [](TumbleRec* rec) {
    const double gravity[3] = {0, 0, 10};
    const TumbleRecState state = state_at(1, 5);
    ASSERT_EQ(tumble_rec_set_gravity(rec, gravity), TUMBLE_REC_OK);
    ASSERT_EQ(tumble_rec_step_begin(rec, 0.0625), TUMBLE_REC_OK);
    ASSERT_EQ(tumble_rec_state(rec, 1, &state), TUMBLE_REC_OK);
    ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK) << tumble_rec_message(rec);
  }));
  ASSERT_TRUE(got.ok()) << got.error().message;
  EXPECT_EQ(got->import.refused, "");
  ASSERT_EQ(got->log.last_step(), 5U);
  const Result<const replay::StepRecord*> step = got->log.read_step(5);
  ASSERT_TRUE(step.ok());
  EXPECT_EQ((*step)->states.frozen, (std::vector<std::uint8_t>{0, 1}));
}

// Two pushes of one body in a step that no log holds: both are told.
TEST(KeptSteps, TheSecondOfTwoValuesDoesNotReplaceTheFirst) {
  const Result<Imported> got = import_bytes(record(1, 1, [](TumbleRec* rec) {
    const TumbleRecState state = state_at(1, 2);
    for (const double push : {1e13, kNan, 5.0}) {
      const double impulse[3] = {push, 0, 0};
      ASSERT_EQ(tumble_rec_push(rec, 1, impulse), TUMBLE_REC_OK);
    }
    ASSERT_EQ(tumble_rec_step_begin(rec, 0.0625), TUMBLE_REC_OK);
    ASSERT_EQ(tumble_rec_state(rec, 1, &state), TUMBLE_REC_OK);
    ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK);
  }));
  ASSERT_TRUE(got.ok()) << got.error().message;
  EXPECT_EQ(got->import.refused, "");
  std::vector<std::string> names;
  for (const replay::Channel& channel : got->log.header().declared.channels) names.push_back(channel.name);
  EXPECT_EQ(names, (std::vector<std::string>{"told.push.x", "told.push.x#2"}));
}

// A value of bytes may have as many as a record of the stream.
TEST(KeptSteps, ALargeValueEndsNoSession) {
  const std::string bytes(3 << 20, 'b');
  Result<Imported> got = import_bytes(record(1, 1, [&](TumbleRec* rec) {
    std::uint32_t channel = 0;
    ASSERT_EQ(tumble_rec_channel(rec, "frame", TUMBLE_REC_WORLD, TUMBLE_REC_BYTES, &channel), TUMBLE_REC_OK);
    const TumbleRecState state = state_at(1, 2);
    ASSERT_EQ(tumble_rec_step_begin(rec, 0.0625), TUMBLE_REC_OK);
    ASSERT_EQ(tumble_rec_state(rec, 1, &state), TUMBLE_REC_OK);
    ASSERT_EQ(tumble_rec_value(rec, channel, 0, 0, bytes.data(), static_cast<std::uint32_t>(bytes.size())), 0);
    ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK);
  }));
  ASSERT_TRUE(got.ok()) << got.error().message;
  EXPECT_EQ(got->import.refused, "");
  const Result<const replay::StepRecord*> step = got->log.read_step(2);
  ASSERT_TRUE(step.ok()) << step.error().message;
  EXPECT_EQ((*step)->extras.values(0).bytes, std::vector<std::string>{bytes});
}

}  // namespace
}  // namespace tumble::test
