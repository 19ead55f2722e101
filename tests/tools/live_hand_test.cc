// The tools, the camera and the sliders of `tumble live`, by real events: what they do is in the log, as inputs and
// views.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "tests/tools/live_window.h"

namespace tumble::test {
namespace {

// The cube in the middle of the picture, the second of the tower.
constexpr sim::BodyId kMiddle = 2;

std::vector<replay::View> views_of(replay::LogReader& log) {
  std::vector<replay::View> views;
  for (std::uint64_t k = log.first_state() + 1; k <= log.last_step(); ++k) {
    const auto record = log.read_step(k);
    EXPECT_TRUE(record.ok());
    views.insert(views.end(), (*record)->extras.views.begin(), (*record)->extras.views.end());
  }
  return views;
}

template <class Input>
std::vector<Input> all_of(replay::LogReader& log) {
  std::vector<Input> found;
  for (const sim::TimedCommand& input : inputs_of(log)) {
    if (const auto* one = std::get_if<Input>(&input.command)) found.push_back(*one);
  }
  return found;
}

class LiveHand : public LiveWindow {
 protected:
  void use(const char* tool, double seconds) {
    display_->key(tool);
    display_->move(kWidth / 2, kHeight / 2);
    sleep_for(0.7);
    display_->hold(1, seconds);
    sleep_for(0.7);
  }
  /// Closes the window; its log.
  replay::LogReader close() {
    sleep_for(0.5);
    display_->key("ctrl+q");
    EXPECT_EQ(wait().exit, 0) << shop_.read("err");
    expect_replays("played.tumble");
    Result<replay::LogReader> log = open("played.tumble");
    EXPECT_TRUE(log.ok());
    return *std::move(log);
  }
};

TEST_F(LiveHand, WakesAndPushesABody) {
  play({"played.toml", "-o", "played.tumble"});
  display_->key("h");
  use("4", 0.1);
  use("2", 0.5);
  replay::LogReader log = close();
  const auto wakes = all_of<sim::Wake>(log);
  ASSERT_EQ(wakes.size(), 1U);
  EXPECT_EQ(wakes[0].id, kMiddle);
  const auto pushes = all_of<sim::Push>(log);
  ASSERT_EQ(pushes.size(), 1U);
  EXPECT_EQ(pushes[0].id, kMiddle);
  EXPECT_FALSE(pushes[0].at_centre);
  const double mass = log.header().scene.boxes[kMiddle - 1].mass, speed = sim::length(pushes[0].impulse) / mass;
  EXPECT_GE(speed, 4.5) << "held for half a second, of 10 m/s at most";
  EXPECT_LE(speed, 10.001);
  EXPECT_GT(pushes[0].impulse.y(), 0) << "away from the camera";
}

TEST_F(LiveHand, FollowsABodyUntilEscape) {
  play({"played.toml", "-o", "played.tumble"});
  display_->key("h");
  use("5", 0.1);
  use("2", 0.5);  // the body goes, and the camera with it
  sleep_for(0.5);
  display_->key("Escape");
  display_->turn(40, 0);  // a view without the body
  replay::LogReader log = close();
  const std::vector<replay::View> views = views_of(log);
  ASSERT_FALSE(views.empty());
  EXPECT_EQ(views.front().follow, 0U);
  EXPECT_EQ(views.back().follow, 0U);
  const replay::View* last = nullptr;
  for (const replay::View& view : views) last = view.follow == kMiddle ? &view : last;
  ASSERT_NE(last, nullptr) << "no view follows the body";
  EXPECT_GT(last->camera.target.y(), views.front().camera.target.y() + 0.2) << "the target goes where the body goes";
}

TEST_F(LiveHand, PansAndZoomsTheCamera) {
  play({"played.toml", "-o", "played.tumble"});
  display_->key("h");
  display_->move(kWidth / 2, kHeight / 2);
  sleep_for(0.5);
  display_->drag(2, 60, 30);
  sleep_for(0.7);
  display_->hold(4, 0.05);  // the wheel, one notch
  replay::LogReader log = close();
  const std::vector<replay::View> views = views_of(log);
  ASSERT_GE(views.size(), 3U);
  const auto eye = [](const replay::View& view) { return sim::Vec3(view.camera.position - view.camera.target); };
  const double far = sim::length(eye(views.front()));
  const replay::View* panned = nullptr;
  for (const replay::View& view : views) {
    const bool moved = sim::length(view.camera.target - views.front().camera.target) > 0.1;
    if (moved && std::fabs(sim::length(eye(view)) - far) < 1e-6) panned = &view;
  }
  ASSERT_NE(panned, nullptr) << "the camera did not shift";
  EXPECT_LT(sim::length(eye(*panned) - eye(views.front())), 1e-6) << "it shifts without turning";
  EXPECT_NEAR(sim::length(eye(views.back())), 0.9 * far, 1e-6 * far) << "a notch of the wheel";
}

// Places in the panel, in pixels down from its upper edge, once "world" is open.
constexpr int kWorldHeader = 360, kGravity = 383, kRate = 406;

TEST_F(LiveHand, SlidersSetGravityAndDt) {
  play({"played.toml", "-o", "played.tumble", "--even"}, "600x600");
  const auto click = [&](int x, int y) {
    display_->move(x, y);
    sleep_for(1);
    display_->hold(1, 0.5);
    sleep_for(1);
  };
  click(60, kWorldHeader);
  click(20, kGravity);  // near the left end: from 20 m/s2 upwards to 30 downwards
  click(20, kRate);     // near the left end: from 10 steps a second to 600
  replay::LogReader log = close();
  const auto gravities = all_of<sim::SetGravity>(log);
  ASSERT_FALSE(gravities.empty());
  EXPECT_GT(gravities.back().gravity.z(), 10);
  EXPECT_EQ(gravities.back().gravity.x(), 0);
  const auto lengths = all_of<sim::SetDt>(log);
  ASSERT_FALSE(lengths.empty());
  EXPECT_GT(lengths.back().dt, 1.0 / 20);
  EXPECT_EQ(dt_of(log, log.last_step()), lengths.back().dt);
}

}  // namespace
}  // namespace tumble::test
