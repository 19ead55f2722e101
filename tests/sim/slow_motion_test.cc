// What a force sets in motion does not fall asleep, however slow it is: method layered, with freezing, against closed
// forms.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::SceneDef;
using sim::Vec3;
using sim::World;

constexpr double kDt = 1.0 / 60;
constexpr double kStart = 0.004;  // m, by which a crate goes too far that starts to slide in the first substep

// A flat crate on the ground under a gravity that is more than friction holds by `gain`, m/s², along x.
struct Slide {
  double down = 9.81, friction = 0, gain = 0.02;
  double speed = 0;  // m/s at the start
};

SceneDef scene_of(const Slide& s) {
  SceneDef scene = on_ground();
  scene.world.method = sim::Method::kLayered;
  scene.world.dt = kDt;
  scene.world.substeps = 8;
  scene.world.gravity = {s.friction * s.down + s.gain, 0, -s.down};
  scene.boxes = {box(1, {1, 1, 0.5}, {0, 0, 0.25})};
  scene.boxes[0].velocity = {s.speed, 0, 0};
  scene.boxes[0].material = {s.friction, s.friction, 0};
  scene.world.ground_material = scene.boxes[0].material;
  return scene;
}

void expect_way(const Slide& s, double seconds) {
  World world = made(scene_of(s));
  const int steps = static_cast<int>(std::lround(seconds / kDt));
  for (int k = 0; k < steps; ++k) advance(world);
  const double way = s.speed * seconds + 0.5 * s.gain * seconds * seconds;
  EXPECT_NEAR(world.bodies().position[0].x(), way, std::fmax(kStart, 0.02 * std::fabs(way)))
      << "gravity " << s.down << " m/s², friction " << s.friction << ", gain " << s.gain << " m/s², from " << s.speed;
  EXPECT_EQ(world.bodies().frozen[0], 0) << s.gain;
}

TEST(SlowMotion, ACrateSlidesHoweverSlowlyItGainsSpeed) {
  for (const double down : {9.81, 1.62, 0.1}) {
    for (const double friction : {0.0, 0.4, 0.8}) {
      for (const double gain : {0.0005, 0.003, 0.02, 0.1}) {
        expect_way({down, friction, gain}, 6);
      }
    }
  }
}

// Its speed falls, is none for a moment, and grows again.
TEST(SlowMotion, ACrateTurnsBackOnASlope) {
  for (const double gain : {-0.02, -0.05, -0.1}) expect_way({9.81, 0, gain, 0.07}, 12);
}

// A box h high and w wide that stands on an edge, its diagonal beyond the upright by `beyond` rad.
double height_after_fall(double w, double h, double beyond) {
  SceneDef scene = on_ground();
  scene.world.method = sim::Method::kLayered;
  scene.world.dt = kDt;
  const double lean = std::atan(w / h) + beyond, diagonal = 0.5 * std::sqrt(w * w + h * h);
  scene.boxes = {box(1, {w, w, h}, {0, 0, diagonal * std::cos(beyond)})};
  scene.boxes[0].orientation = turn({0, 1, 0}, std::cos(lean), std::sin(lean));
  World world = made(scene);
  const double seconds = 12 * std::sqrt(h / 9.81) + 2;
  for (int k = 0; k * kDt < seconds; ++k) advance(world);
  return world.bodies().position[0].z();
}

TEST(SlowMotion, ABoxBeyondItsBalanceFalls) {
  for (const double h : {0.1, 1.0, 10.0, 100.0}) {
    for (const double slender : {1.0, 3.0, 10.0}) {
      for (const double beyond : {0.002, 0.005, 0.02}) {
        const double w = h / slender;
        EXPECT_NEAR(height_after_fall(w, h, beyond), 0.5 * w, 0.02 * h) << h << " m, " << slender << ", " << beyond;
      }
    }
  }
}

}  // namespace
}  // namespace tumble::test
