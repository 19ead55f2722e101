// Coulomb's friction where bodies spin, method layered. A square plate on four corners that share its weight is
// the reference: each corner is braked against its own slip, and the test follows that by Runge's rule in small steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::SceneDef;
using sim::Vec3;
using sim::World;

constexpr double kGravity = 9.81, kSide = 2, kHeight = 0.05;

struct Spin {
  double speed = 0, spin = 0;  // m/s along x, rad/s about z
  double degrees = 0;          // of a slope down x
  double friction = 0.4, friction_dynamic = 0.4;
};

struct Steps {
  double dt;
  std::uint32_t substeps;
};
constexpr Steps kSteps[] = {{1.0 / 60, 8}, {1.0 / 60, 64}, {1.0 / 240, 8}, {1.0 / 1000, 4}, {1.0 / 30, 16}};

struct Plate {
  double x = 0, y = 0, angle = 0, vx = 0, vy = 0, spin = 0;
};

// Adds `part` of the motion and its change to a plate.
Plate after(const Spin& s, const Plate& from, const Plate& rate, double seconds) {
  const double t = s.degrees * std::numbers::pi / 180, load = kGravity * std::cos(t) / 4;
  double ax = kGravity * std::sin(t), ay = 0, turn = 0;
  for (int corner = 0; corner < 4; ++corner) {
    const double at = rate.angle + std::numbers::pi / 4 * (2 * corner + 1), arm = kSide * std::sqrt(0.5);
    const double rx = arm * std::cos(at), ry = arm * std::sin(at);
    const double sx = rate.vx - rate.spin * ry, sy = rate.vy + rate.spin * rx;
    const double brake = -s.friction_dynamic * load / (std::hypot(sx, sy) + 1e-9);
    ax += brake * sx;
    ay += brake * sy;
    turn += brake * (rx * sy - ry * sx) / (kSide * kSide / 6);
  }
  return {from.x + rate.vx * seconds, from.y + rate.vy * seconds, from.angle + rate.spin * seconds,
          from.vx + ax * seconds,     from.vy + ay * seconds,     from.spin + turn * seconds};
}

Plate on_four_corners(const Spin& s, double seconds) {
  constexpr double kStep = 1e-4;
  Plate plate = {0, 0, 0, s.speed, 0, s.spin};
  for (double t = 0; t < seconds; t += kStep) {
    if (s.degrees == 0 && std::hypot(plate.vx, plate.vy) + std::fabs(plate.spin) < 3e-3) break;
    plate = after(s, plate, after(s, plate, plate, kStep / 2), kStep);
  }
  return plate;
}

Plate by_layers(const Spin& s, double seconds, const Steps& steps) {
  SceneDef scene = on_ground();
  const double t = s.degrees * std::numbers::pi / 180;
  scene.world.method = sim::Method::kLayered;
  scene.world.dt = steps.dt;
  scene.world.substeps = steps.substeps;
  scene.world.freezing = false;
  scene.world.gravity = Vec3(std::sin(t), 0, -std::cos(t)) * kGravity;
  scene.boxes = {box(1, {kSide, kSide, kHeight}, {0, 0, kHeight / 2})};
  scene.boxes[0].velocity = {s.speed, 0, 0};
  scene.boxes[0].spin = {0, 0, s.spin};
  scene.world.ground_material = scene.boxes[0].material = {s.friction, s.friction_dynamic, 0};
  World world = made(scene);
  Plate plate;
  const auto count = static_cast<int>(std::lround(seconds / steps.dt));
  for (int k = 0; k < count; ++k) {
    const double before = world.bodies().spin[0].z();
    advance(world);
    plate.angle += 0.5 * (before + world.bodies().spin[0].z()) * steps.dt;
  }
  const Vec3 at = world.bodies().position[0], v = world.bodies().velocity[0];
  return {at.x(), at.y(), plate.angle, v.x(), v.y(), world.bodies().spin[0].z()};
}

// Within `part` of the way, of the turn, and of the speeds in the end.
void expect_four_corners(const Spin& s, double seconds, double part) {
  const Plate wanted = on_four_corners(s, seconds);
  for (const Steps& steps : kSteps) {
    SCOPED_TRACE(testing::Message() << "speed " << s.speed << ", spin " << s.spin << ", dt " << steps.dt
                                    << ", substeps " << steps.substeps);
    const Plate got = by_layers(s, seconds, steps);
    EXPECT_NEAR(got.x, wanted.x, part * wanted.x + 0.002);
    EXPECT_LT(std::fabs(got.y - wanted.y), 0.02 * std::max(wanted.x, 0.1));
    EXPECT_NEAR(got.angle, wanted.angle, part * wanted.angle + 0.002);
    EXPECT_NEAR(got.vx, wanted.vx, part * wanted.vx + 0.005);
    EXPECT_NEAR(got.spin, wanted.spin, part * wanted.spin + 0.005);
  }
}

TEST(SpinFriction, SpinWeakensTheFrictionOfASlide) {
  for (const auto& [speed, spin] : {std::pair(1.0, 6.0), {3.0, 6.0}, {2.0, 2.0}, {0.3, 8.0}, {3.0, 0.5}}) {
    expect_four_corners({.speed = speed, .spin = spin}, 3, 0.06);
  }
}

TEST(SpinFriction, APlateThatSpinsOnASlopeSlides) { expect_four_corners({.spin = 40, .degrees = 20}, 2, 0.03); }

TEST(SpinFriction, WhatSpinsHasTheDynamicCoefficient) {
  for (const Steps& steps : kSteps) {
    const Plate free = by_layers({.spin = 10, .friction = 0.8, .friction_dynamic = 0}, 1, steps);
    EXPECT_NEAR(free.spin, 10, 1e-9) << steps.dt << ", " << steps.substeps;
  }
  expect_four_corners({.spin = 10, .friction = 0.9, .friction_dynamic = 0.2}, 1, 0.03);
  expect_four_corners({.spin = 6, .friction = 0.2, .friction_dynamic = 0.2}, 1, 0.03);
}

}  // namespace
}  // namespace tumble::test
