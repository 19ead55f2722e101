// What the recorder says of the first difference from an earlier stream: names, not numbers of the format.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "tests/recorder/recorded.h"
#include "tests/support/program.h"

namespace tumble::test {
namespace {

/// One step of one body, with a channel and a phase where they are asked for.
struct Told {
  const char* channel = nullptr;
  const char* phase = nullptr;
  char up = 'z';
};

std::string difference(const Workshop& shop, const Told& told, const std::string& to, const std::string& earlier) {
  const std::string path = shop.path(to), verify = shop.path(earlier);
  TumbleRecDef def = {};
  def.engine = "test engine", def.precision_bits = 53, def.path = path.c_str(), def.up = told.up;
  def.phases = "move,solve";
  if (!earlier.empty()) def.verify = verify.c_str();
  TumbleRec* rec = tumble_rec_create(&def);
  const TumbleRecBody body = small_cube(1);
  tumble_rec_body(rec, &body);
  std::uint32_t channel = 0;
  if (told.channel != nullptr) tumble_rec_channel(rec, told.channel, TUMBLE_REC_WORLD, TUMBLE_REC_F64, &channel);
  tumble_rec_step_begin(rec, 0.0625);
  const TumbleRecState state = state_at(1, 1);
  tumble_rec_state(rec, 1, &state);
  if (told.phase != nullptr) tumble_rec_phase_hash(rec, told.phase == std::string("move") ? 0 : 1, 7);
  tumble_rec_step_end(rec);
  EXPECT_STREQ(tumble_rec_message(rec), "");
  const TumbleRecDifference* found = tumble_rec_difference(rec);
  std::string text = found != nullptr ? found->text : "";
  tumble_rec_close(rec);
  return text;
}

TEST(VerifyWords, WhatOneOfTwoLacksIsCalledByItsName) {
  const Workshop shop;
  (void)difference(shop, {}, "plain", "");
  (void)difference(shop, {.channel = "knee"}, "channel", "");
  (void)difference(shop, {.phase = "solve"}, "phase", "");
  EXPECT_EQ(difference(shop, {.channel = "knee"}, "now", "plain"),
            "step 0: channel: knee: absent in the earlier stream, present now");
  EXPECT_EQ(difference(shop, {}, "now", "channel"), "step 0: channel: knee: present in the earlier stream, absent now");
  EXPECT_EQ(difference(shop, {.phase = "solve"}, "now", "plain"),
            "step 1: phase hash: solve: absent in the earlier stream, present now");
  EXPECT_EQ(difference(shop, {}, "now", "phase"),
            "step 1: phase hash: solve: present in the earlier stream, absent now");
}

TEST(VerifyWords, AxesAreLetters) {
  const Workshop shop;
  (void)difference(shop, {}, "plain", "");
  EXPECT_EQ(difference(shop, {.up = 'y'}, "now", "plain"), "step 0: start: up: z in the earlier stream, y now");
}

}  // namespace
}  // namespace tumble::test
