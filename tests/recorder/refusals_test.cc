// What contradicts itself is refused by the call that gives it, and what the recorder takes can be read.
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/recorder/imported.h"
#include "tests/recorder/recorded.h"

namespace tumble::test {
namespace {

TEST(Refusals, ASecondValueOfOneChannelAndBodyInAStep) {
  std::string message;
  (void)record(2, 3, [&](TumbleRec* rec) {
    std::uint32_t joint = 0, pair = 0;
    EXPECT_EQ(tumble_rec_channel(rec, "joint", TUMBLE_REC_OF_BODY, TUMBLE_REC_F64, &joint), TUMBLE_REC_OK);
    EXPECT_EQ(tumble_rec_channel(rec, "pair", TUMBLE_REC_OF_PAIR, TUMBLE_REC_F64, &pair), TUMBLE_REC_OK);
    const double value = 1;
    for (int k = 0; k < 2; ++k) {  // once in each step is fine
      EXPECT_EQ(tumble_rec_step_begin(rec, 0.0625), TUMBLE_REC_OK);
      for (std::uint64_t id = 1; id <= 2; ++id) {
        TumbleRecState state = state_at(id, 3);
        state.asleep = id == 2 ? 1 : 0;
        EXPECT_EQ(tumble_rec_state(rec, id, &state), TUMBLE_REC_OK);
        EXPECT_EQ(tumble_rec_f64(rec, joint, id, 0.5), TUMBLE_REC_OK);
      }
      EXPECT_EQ(tumble_rec_value(rec, pair, 1, 2, &value, 1), TUMBLE_REC_OK);
      EXPECT_EQ(tumble_rec_value(rec, pair, 2, 1, &value, 1), TUMBLE_REC_OK);
      EXPECT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK);
    }
    EXPECT_EQ(tumble_rec_step_begin(rec, 0.0625), TUMBLE_REC_OK);
    EXPECT_EQ(tumble_rec_f64(rec, joint, 1, 0.5), TUMBLE_REC_OK);
    EXPECT_EQ(tumble_rec_f64(rec, joint, 1, 0.5), TUMBLE_REC_BAD_CALL);
    message = tumble_rec_message(rec);
  });
  EXPECT_NE(message.find("channel \"joint\": found a second value of bodies 1 and 0 in a step"), std::string::npos)
      << message;
}

TEST(Refusals, PhasesWithOneName) {
  std::string message;
  (void)record(
      1, 0, [&](TumbleRec* rec) { message = tumble_rec_message(rec); },
      [](TumbleRecDef& def) { def.phases = "solve,move,solve"; });
  EXPECT_EQ(message, "phases: found \"solve\" twice, wanted names that differ");
}

// Also long after its removal: the recorder forgets the body, not the id.
TEST(Refusals, AnIdThatABodyHad) {
  constexpr std::uint64_t kBodies = 200, kSteps = 600;
  std::string message;
  (void)record(1, 0, [&](TumbleRec* rec) {
    for (std::uint64_t id = 2; id <= kBodies; ++id) {
      const TumbleRecBody body = small_cube(id);
      ASSERT_EQ(tumble_rec_body(rec, &body), TUMBLE_REC_OK) << tumble_rec_message(rec);
    }
    for (std::uint64_t k = 1; k <= kSteps; ++k) {
      if (k == 2) {
        for (std::uint64_t id = 2; id <= kBodies; ++id) ASSERT_EQ(tumble_rec_remove(rec, id), TUMBLE_REC_OK);
      }
      ASSERT_EQ(tumble_rec_step_begin(rec, 0.0625), TUMBLE_REC_OK);
      for (std::uint64_t id = 1; id <= (k == 1 ? kBodies : 1); ++id) {
        const TumbleRecState state = state_at(id, 1);
        ASSERT_EQ(tumble_rec_state(rec, id, &state), TUMBLE_REC_OK);
      }
      ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK);
    }
    const TumbleRecBody again = small_cube(150), fresh = small_cube(kBodies + 1);
    EXPECT_EQ(tumble_rec_body(rec, &fresh), TUMBLE_REC_OK) << tumble_rec_message(rec);
    EXPECT_EQ(tumble_rec_body(rec, &again), TUMBLE_REC_BAD_CALL);
    message = tumble_rec_message(rec);
  });
  EXPECT_NE(message.find("step 601: found body 150, wanted an id of 1 to 2^53 - 1 that no body had"), std::string::npos)
      << message;
}

TEST(Refusals, ManyValuesOfAStepAreKeptApart) {
  const auto imported = import_bytes(record(200, 1, [](TumbleRec* rec) {
    std::uint32_t channels[8];
    for (std::uint32_t c = 0; c < 8; ++c) {
      const std::string name = "c" + std::to_string(c);
      ASSERT_EQ(tumble_rec_channel(rec, name.c_str(), TUMBLE_REC_OF_BODY, TUMBLE_REC_F64, &channels[c]), TUMBLE_REC_OK);
    }
    tumble_rec_step_begin(rec, 0.0625);
    for (std::uint64_t id = 1; id <= 200; ++id) {
      const TumbleRecState state = state_at(id, 2);
      ASSERT_EQ(tumble_rec_state(rec, id, &state), TUMBLE_REC_OK);
      for (const std::uint32_t c : channels) ASSERT_EQ(tumble_rec_f64(rec, c, id, 1.5), TUMBLE_REC_OK);
    }
    ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK) << tumble_rec_message(rec);
  }));
  ASSERT_TRUE(imported.ok()) << imported.error().message;
}

TEST(Refusals, AContactOrAValueOfABodyThatIsNone) {
  const auto refused = [](const auto& call) {
    std::string message;
    (void)record(2, 1, [&](TumbleRec* rec) {
      std::uint32_t joint = 0;
      tumble_rec_channel(rec, "joint", TUMBLE_REC_OF_BODY, TUMBLE_REC_F64, &joint);
      tumble_rec_remove(rec, 2);
      tumble_rec_step_begin(rec, 0.0625);
      EXPECT_EQ(call(rec, joint), TUMBLE_REC_BAD_CALL);
      message = tumble_rec_message(rec);
    });
    return message;
  };
  const auto contact = [](std::uint64_t a, std::uint64_t b) {
    return [a, b](TumbleRec* rec, std::uint32_t) {
      TumbleRecContact told = {};
      told.a = a, told.b = b;
      return tumble_rec_contact(rec, &told);
    };
  };
  EXPECT_NE(refused(contact(1, 9)).find("a contact of body 9"), std::string::npos);
  EXPECT_NE(refused(contact(1, 2)).find("a contact of body 2"), std::string::npos) << "it was removed";
  EXPECT_NE(refused(contact(1, 1)).find("a contact of body 1 with itself"), std::string::npos);
  const auto value = [](TumbleRec* rec, std::uint32_t joint) { return tumble_rec_f64(rec, joint, 9, 1); };
  EXPECT_NE(refused(value).find("a value of body 9"), std::string::npos);
  const auto twice = [](TumbleRec* rec, std::uint32_t) {
    const TumbleRecState state = state_at(1, 2);
    tumble_rec_state(rec, 1, &state);
    return tumble_rec_state(rec, 1, &state);
  };
  EXPECT_NE(refused(twice).find("found two states of body 1 in a step"), std::string::npos);
}

/// What the recorder says of a call between two steps; the session before can be read.
std::string said_of(const std::function<void(TumbleRec*)>& call) {
  std::string message;
  const auto imported = import_bytes(record(2, 2, [&](TumbleRec* rec) {
    call(rec);
    tumble_rec_finish(rec);
    message = tumble_rec_message(rec);
  }));
  EXPECT_TRUE(imported.ok()) << message << imported.error().message;
  EXPECT_EQ(imported.ok() ? imported->log.last_step() : 0, 2U) << message;
  return message;
}

TEST(Refusals, VectorsThatAreNull) {
  const double v[3] = {1, 2, 3};
  EXPECT_EQ(said_of([](TumbleRec* rec) { tumble_rec_push(rec, 1, nullptr); }),
            "step 3: a push: found NULL, wanted three numbers");
  const double* const none = nullptr;
  for (const auto& [linear, spin] : {std::pair(none, static_cast<const double*>(v)),
                                     std::pair(static_cast<const double*>(v), none), std::pair(none, none)}) {
    const auto told = [linear = linear, spin = spin](TumbleRec* rec) { tumble_rec_set_velocity(rec, 1, linear, spin); };
    EXPECT_EQ(said_of(told), "step 3: a velocity: found NULL, wanted three numbers");
  }
  EXPECT_EQ(said_of([](TumbleRec* rec) { tumble_rec_set_gravity(rec, nullptr); }),
            "step 3: a gravity: found NULL, wanted three numbers");
}

TEST(Refusals, WhatBelongsToAStepIsToldInIt) {
  EXPECT_EQ(said_of([](TumbleRec* rec) {
              TumbleRecPoint point = {};
              TumbleRecContact told = {};
              told.a = 1, told.normal[2] = -1, told.points = &point, told.point_count = 1;
              tumble_rec_contact(rec, &told);
            }),
            "step 3: found a contact between steps, wanted step_begin before");
  EXPECT_EQ(said_of([](TumbleRec* rec) { tumble_rec_note(rec, "the end"); }),
            "step 3: found a note after the last step, wanted it before step_end");
}

TEST(Refusals, AContactWithoutPointsIsNamedByTheImport) {
  const auto imported = import_bytes(record(1, 1, [](TumbleRec* rec) {
    tumble_rec_step_begin(rec, 0.0625);
    const TumbleRecState state = state_at(1, 2);
    tumble_rec_state(rec, 1, &state);
    TumbleRecContact told = {};
    told.a = 1, told.normal[2] = -1;
    EXPECT_EQ(tumble_rec_contact(rec, &told), TUMBLE_REC_OK);
    EXPECT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK) << tumble_rec_message(rec);
  }));
  ASSERT_TRUE(imported.ok()) << imported.error().message;
  EXPECT_TRUE(
      mentions(imported->import.warnings,
               "step 2, contact of 1 and the ground: has no points, so the log keeps it in a channel, told.contacts or "
               "told.ground_contacts"));
}

/// Two steps with `channels` channels of `numbers` numbers a value.
StreamBytes record_channels(std::uint32_t channels, std::uint32_t numbers, std::uint32_t steps) {
  return record(1, 1, [=](TumbleRec* rec) {
    std::vector<std::uint32_t> made(channels);
    for (std::uint32_t c = 0; c < channels; ++c) {
      const std::string name = "channel " + std::to_string(c);
      ASSERT_EQ(tumble_rec_channel(rec, name.c_str(), TUMBLE_REC_WORLD, TUMBLE_REC_F64, &made[c]), TUMBLE_REC_OK)
          << tumble_rec_message(rec);
    }
    const std::vector<double> values(numbers, 0.25);
    for (std::uint32_t k = 2; k < steps + 2; ++k) {
      tumble_rec_step_begin(rec, 0.0625);
      const TumbleRecState state = state_at(1, k);
      tumble_rec_state(rec, 1, &state);
      for (const std::uint32_t c : made) tumble_rec_value(rec, c, 0, 0, values.data(), numbers);
      ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK) << tumble_rec_message(rec);
    }
  });
}

TEST(Refusals, EveryNumberOfChannelsThatTheRecorderTakesCanBeRead) {
  auto most = import_bytes(record_channels(4096, 1, 140));
  ASSERT_TRUE(most.ok()) << most.error().message;
  EXPECT_EQ(most->log.header().declared.channels.size(), 4096U);
  for (std::uint64_t k = 1; k <= most->log.last_step(); ++k) {
    const auto step = most->log.read_step(k);
    ASSERT_TRUE(step.ok()) << step.error().message;
  }
  std::string message;
  (void)record(1, 1, [&](TumbleRec* rec) {
    std::uint32_t made = 0;
    for (int c = 0; c < 4096; ++c)
      tumble_rec_channel(rec, std::to_string(c).c_str(), TUMBLE_REC_WORLD, TUMBLE_REC_F64, &made);
    EXPECT_EQ(tumble_rec_channel(rec, "more", TUMBLE_REC_WORLD, TUMBLE_REC_F64, &made), TUMBLE_REC_BAD_CALL);
    message = tumble_rec_message(rec);
  });
  EXPECT_NE(message.find("4096"), std::string::npos) << message;
}

TEST(Refusals, ValuesOfManyNumbersBecomeBytesWhereALogHasNoRoom) {
  auto wide = import_bytes(record_channels(200, 100, 2));
  ASSERT_TRUE(wide.ok()) << wide.error().message;
  EXPECT_TRUE(mentions(wide->import.warnings, "of several numbers a value are logged as bytes"));
  const auto step = wide->log.read_step(2);
  ASSERT_TRUE(step.ok()) << step.error().message;
}

}  // namespace
}  // namespace tumble::test
