// A sync test: steps that a rollback took again with equal inputs have equal results, or the first other one is named.
#include "replay/stream/rollback_check.h"

#include <gtest/gtest.h>

#include "tests/recorder/recorded.h"

namespace tumble::test {
namespace {

/// Steps 3 and 4 of three bodies, recorded again after a rewind; body 1 is `off` higher in step 4, and pushed before
/// step 3 by `push`.
StreamBytes taken_again(double off, double push) {
  const auto again = [&](TumbleRec* rec) {
    ASSERT_EQ(tumble_rec_rewind(rec, 2), TUMBLE_REC_OK) << tumble_rec_message(rec);
    for (std::uint64_t k = 3; k <= 4; ++k) {
      const double impulse[3] = {push, 0, 0};
      if (push != 0 && k == 3) tumble_rec_push(rec, 1, impulse);
      tumble_rec_step_begin(rec, 0.0625);
      for (std::uint64_t id = 1; id <= 3; ++id) {
        TumbleRecState state = state_at(id, k);
        if (id == 2) state = state_at(id, 3), state.asleep = 1;
        if (id == 1 && k == 4) state.position[2] += off;
        tumble_rec_state(rec, id, &state);
      }
      ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK) << tumble_rec_message(rec);
    }
  };
  return record(3, 4, again, [](TumbleRecDef& def) { def.rollback_steps = 4; });
}

replay::RollbackCheck check(const StreamBytes& bytes) {
  const Result<replay::StreamReader> stream = open_stream(bytes);
  EXPECT_TRUE(stream.ok());
  Result<replay::RollbackCheck> found = replay::check_rollbacks(*stream);
  EXPECT_TRUE(found.ok());
  return *found;
}

TEST(RollbackCheck, EqualInputsAndEqualResultsPass) {
  const replay::RollbackCheck found = check(taken_again(0, 0));
  EXPECT_EQ(found.compared, 2U);
  EXPECT_EQ(found.not_compared, 0U);
  EXPECT_FALSE(found.first) << describe(found);
  EXPECT_EQ(describe(found), "2 steps taken again with equal inputs, all with equal results");
}

TEST(RollbackCheck, NamesTheFirstStepBodyAndFieldThatCameOutOtherwise) {
  const replay::RollbackCheck found = check(taken_again(0.5, 0));
  ASSERT_TRUE(found.first);
  EXPECT_EQ(found.first->step, 4U);
  EXPECT_EQ(found.first->body, 1U);
  EXPECT_EQ(found.first->field, "position.z");
  EXPECT_EQ(found.first->before, "4.5");
  EXPECT_EQ(found.first->after, "5");
  EXPECT_EQ(found.compared, 2U);
}

// A body that sleeps has no state in a step, but every body has one after a rewind.
TEST(RollbackCheck, ASleeperThatTellsItsStateAgainIsNoDifference) {
  const auto asleep = [](double off, bool is_pushed) {
    return check(record(
        2, 4,
        [=](TumbleRec* rec) {
          const double none[3] = {0, 0, 0};
          const auto step = [&](std::uint64_t k, bool tells) {
            if (is_pushed && k == 6) tumble_rec_push(rec, 2, none);
            TumbleRecState one = state_at(1, k), two = state_at(2, 3);
            two.asleep = is_pushed && k >= 6 ? 0 : 1;
            two.position[2] += tells ? off : 0;
            tumble_rec_step_begin(rec, 0.0625);
            tumble_rec_state(rec, 1, &one);
            if (tells || (is_pushed && k >= 6)) tumble_rec_state(rec, 2, &two);
            ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK) << tumble_rec_message(rec);
          };
          for (std::uint64_t k = 5; k <= 7; ++k) step(k, false);
          ASSERT_EQ(tumble_rec_rewind(rec, is_pushed ? 5 : 4), TUMBLE_REC_OK) << tumble_rec_message(rec);
          for (std::uint64_t k = is_pushed ? 6 : 5; k <= 7; ++k) step(k, true);
        },
        [](TumbleRecDef& def) { def.rollback_steps = 4; }));
  };
  EXPECT_EQ(describe(asleep(0, false)), "3 steps taken again with equal inputs, all with equal results");
  EXPECT_EQ(describe(asleep(0, true)), "2 steps taken again with equal inputs, all with equal results");
  const replay::RollbackCheck moved = asleep(0.5, false);
  ASSERT_TRUE(moved.first);
  EXPECT_EQ(moved.first->field, "position.z");
}

TEST(RollbackCheck, OtherInputsAreNoFault) {
  const replay::RollbackCheck found = check(taken_again(0.5, 2));
  EXPECT_FALSE(found.first) << describe(found);
  EXPECT_EQ(found.compared, 0U);
  EXPECT_EQ(found.not_compared, 2U);
}

TEST(RollbackCheck, KeepsWhatBecameOfEachStep) {
  const replay::RollbackCheck same = check(taken_again(0, 0)), off = check(taken_again(0.5, 0));
  ASSERT_EQ(same.steps.size(), 2U);
  EXPECT_EQ(same.steps[1].first, 4U);
  EXPECT_EQ(same.steps[1].second, (replay::Superseded{true, ""}));
  EXPECT_EQ(off.steps[0].second, (replay::Superseded{true, ""}));
  EXPECT_EQ(off.steps[1].second, (replay::Superseded{true, "body 1 position.z: 4.5 → 5"}));
  const replay::RollbackCheck other = check(taken_again(0.5, 2));
  EXPECT_EQ(other.steps[0].second, (replay::Superseded{false, "input 1: none → push of body 1"}));
  EXPECT_EQ(other.steps[1].second, (replay::Superseded{false, "not compared: step 3 had other inputs"}));
}

// A control of the engine's own decides as well whether a step was taken again with equal inputs.
TEST(RollbackCheck, ComparesNamedInputs) {
  const auto taken = [](const char* first, const char* second) {
    const auto step = [](TumbleRec* rec, const char* control) {
      const TumbleRecState state = state_at(1, 1);
      tumble_rec_input(rec, "throttle", 1, control, 1);
      tumble_rec_step_begin(rec, 0.0625);
      tumble_rec_state(rec, 1, &state);
      ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK) << tumble_rec_message(rec);
    };
    const auto both = [&](TumbleRec* rec) {
      step(rec, first);
      ASSERT_EQ(tumble_rec_rewind(rec, 1), TUMBLE_REC_OK) << tumble_rec_message(rec);
      step(rec, second);
    };
    return check(record(1, 1, both, [](TumbleRecDef& def) { def.rollback_steps = 4; }));
  };
  EXPECT_EQ(taken("a", "a").steps[0].second, (replay::Superseded{true, ""}));
  EXPECT_EQ(taken("a", "b").steps[0].second,
            (replay::Superseded{false, "input 1: \"throttle\" of body 1 has other values"}));
}

}  // namespace
}  // namespace tumble::test
