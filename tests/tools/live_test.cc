// `tumble live` as a person plays it: a window on a display without a screen, real events of mouse and keyboard, the
// log, and what the window showed.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <string>
#include <variant>
#include <vector>

#include "tests/support/pictures.h"
#include "tests/tools/live_window.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/live_options.h"

namespace tumble::test {
namespace {

// The first of the two single steps: both have the scene's dt to the bit, where a clock's never has.
std::uint64_t first_single_step(replay::LogReader& log) {
  for (std::uint64_t k = 2; k < log.last_step(); ++k) {
    if (dt_of(log, k) == kDt && dt_of(log, k + 1) == kDt) return k;
  }
  return 0;
}

TEST_F(LiveWindow, ThrowsPausesStepsSlowsDownAndTheLogReplays) {
  play({"played.toml", "-o", "played.tumble", "--samples", "1"});
  for (const int x : {330, 360, 390}) {
    display_->move(x, 150);
    display_->hold(1, 0.3);
    sleep_for(0.3);
  }
  display_->key("h");  // nothing but the picture
  display_->key("space");
  sleep_for(1.5);
  const render::Image paused = display_->picture(kWidth, kHeight);
  display_->turn(60, 20);
  sleep_for(1.5);
  const render::Image turned = display_->picture(kWidth, kHeight);
  EXPECT_GT(difference(paused, turned).far_off, 2000U) << "the camera did not turn";
  display_->key("n");
  sleep_for(0.7);
  display_->key("n");
  sleep_for(0.7);
  for (int k = 0; k < 3; ++k) display_->key("minus");
  display_->key("space");
  sleep_for(1);
  display_->key("ctrl+q");
  EXPECT_EQ(wait().exit, 0) << shop_.read("err");

  expect_replays("played.tumble");
  Result<replay::LogReader> log = open("played.tumble");
  ASSERT_TRUE(log.ok());
  std::size_t throws = 0;
  for (const sim::TimedCommand& input : inputs_of(*log)) {
    if (const auto* thrown = std::get_if<sim::Throw>(&input.command)) {
      ++throws;
      EXPECT_GT(sim::length(thrown->box.velocity), 4.5) << "held for a third of a second";
    }
  }
  EXPECT_EQ(throws, 3U);
  const std::uint64_t single = first_single_step(*log);
  ASSERT_GT(single, 1U) << "no two single steps";
  EXPECT_LT(dt_of(*log, log->last_step()), kDt) << "an eighth of the speed, and four frames late at most";

  // The window showed the state before the single steps, pixel for pixel as `render` draws it.
  const Outcome drawn = shop_.run({"render", "played.tumble", "--step", std::to_string(single - 1), "--size", kSize,
                                   "--samples", "1", "-o", "wanted.png"});
  ASSERT_EQ(drawn.exit, 0) << drawn.err;
  const render::Image wanted = image_of("wanted.png");
  EXPECT_LE(difference(wanted, paused).far_off, 20U);
  const Outcome other =
      shop_.run({"render", "played.tumble", "--step", "0", "--size", kSize, "--samples", "1", "-o", "other.png"});
  ASSERT_EQ(other.exit, 0) << other.err;
  EXPECT_GT(difference(image_of("other.png"), paused).far_off, 100U) << "the test tells states apart";

  // The log has what was seen: the paused state from the turned camera is in the movie.
  const Outcome seen = shop_.run(
      {"render", "played.tumble", "--as-seen", "--fps", "2", "--size", kSize, "--samples", "1", "-o", "seen/"});
  ASSERT_EQ(seen.exit, 0) << seen.err;
  std::uint64_t nearest = kWidth * kHeight;
  for (const std::string& name : shop_.names_with("frame_")) {
    nearest = std::min(nearest, difference(image_of("seen/" + name), turned).far_off);
  }
  EXPECT_LE(nearest, 20U);

  // Its inputs, recorded again.
  const std::string steps = std::to_string(log->last_step());
  const Outcome again =
      shop_.run({"record", "--from", "played.tumble:0", "--steps", steps, "-o", "again.tumble", "--quiet"});
  ASSERT_EQ(again.exit, 0) << again.err;
  Result<replay::LogReader> second = open("again.tumble");
  ASSERT_TRUE(second.ok());
  EXPECT_EQ((*second->read_hashes(second->last_step()))->state_hash, (*log->read_hashes(log->last_step()))->state_hash);
}

TEST_F(LiveWindow, RemovesABodyAndGoesBack) {
  play({"played.toml", "-o", "played.tumble"});
  const render::Image running = display_->picture(kWidth, kHeight);
  display_->key("h");
  sleep_for(0.7);
  EXPECT_GT(difference(running, display_->picture(kWidth, kHeight)).far_off, 5000U) << "the panel";
  display_->key("3");  // remove
  display_->move(kWidth / 2, kHeight / 2);
  sleep_for(0.5);
  display_->hold(1, 0.1);
  sleep_for(0.7);
  display_->key("b");  // back to the start, into another log
  sleep_for(1.5);
  display_->key("ctrl+q");
  EXPECT_EQ(wait().exit, 0) << shop_.read("err");
  Result<replay::LogReader> log = open("played.tumble");
  ASSERT_TRUE(log.ok());
  std::size_t removals = 0;
  for (const sim::TimedCommand& input : inputs_of(*log)) removals += std::holds_alternative<sim::Remove>(input.command);
  EXPECT_EQ(removals, 1U);
  expect_replays("played.tumble");
  expect_replays("played_from_0.tumble");
}

TEST_F(LiveWindow, CtrlCLeavesAWholeLog) {
  play({"played.toml", "-o", "played.tumble"});
  send(SIGINT);
  EXPECT_EQ(wait().exit, 0);
  expect_replays("played.tumble");
}

TEST_F(LiveWindow, ALostDisplayLeavesAWholeLog) {
  play({"played.toml", "-o", "played.tumble"});
  display_->close();
  EXPECT_EQ(wait().exit, 4) << shop_.read("err");
  expect_replays("played.tumble");
}

TEST_F(LiveWindow, ACrashLosesAtMostTheOpenChunk) {
  play({"played.toml", "-o", "played.tumble"});
  sleep_for(2);
  send(SIGKILL);
  EXPECT_EQ(wait().signal, SIGKILL);
  Result<replay::LogReader> log = open("played.tumble");
  ASSERT_TRUE(log.ok());
  EXPECT_GT(log->last_step(), 10U) << "steps of the seconds before the last";
  const Outcome replayed = shop_.run({"replay", "played.tumble"});
  EXPECT_EQ(replayed.exit, 3) << "the log is torn, and its steps are right";
}

TEST_F(LiveWindow, PlaysOnFromALog) {
  ASSERT_EQ(shop_.run({"record", "played.toml", "-o", "first.tumble", "--steps", "50", "--quiet"}).exit, 0);
  play({"--from", "first.tumble:30"});
  display_->key("ctrl+q");
  EXPECT_EQ(wait().exit, 0) << shop_.read("err");
  Result<replay::LogReader> log = open("first_from_30.tumble");
  ASSERT_TRUE(log.ok());
  EXPECT_EQ(log->first_state(), 30U);
  expect_replays("first_from_30.tumble");
}

TEST(Live, WithoutADisplaySaysSoInOneLineAndNamesView) {
  const Workshop shop;
  shop.write("played.toml", kScene);
  const Outcome outcome = shop.run_after("unset DISPLAY WAYLAND_DISPLAY; ", {"live", "played.toml"});
  EXPECT_EQ(outcome.exit, 4);
  EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
  EXPECT_NE(outcome.err.find("tumble view"), std::string::npos) << outcome.err;
  EXPECT_TRUE(shop.names_with("_live").empty()) << "a log without a session";
}

TEST(Live, ArgumentsReachTheWindowAsTheyWereGiven) {
  tools::LiveArguments given;
  given.scene = "-odd name.toml";
  given.log = "a b.tumble";
  given.overrides = {"grid.rows=7", "world.dt=0.01"};
  given.threads = 2;
  given.measure = 0.125;
  given.even = true;
  given.effects = "-bloom,-dof";
  tools::LiveArguments read;
  tools::Arguments arguments("tumble live", "");
  declare_arguments(arguments, read);
  ASSERT_EQ(arguments.read(words_of(given)).kind, tools::Reading::Kind::kRun);
  EXPECT_EQ(read.scene, given.scene);
  EXPECT_EQ(read.log, given.log);
  EXPECT_EQ(read.overrides, given.overrides);
  EXPECT_EQ(read.threads, given.threads);
  EXPECT_EQ(read.measure, given.measure);
  EXPECT_EQ(read.even, given.even);
  EXPECT_EQ(read.effects, given.effects);
}

}  // namespace
}  // namespace tumble::test
