// Free flight: the ballistic rule, air drag, and torque-free rotation.
#include "src/thesis/integrate.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "src/math/grid.h"
#include "src/model/mass.h"
#include "src/world/free_flight.h"
#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::Axes;
using sim::Quat;
using sim::SceneDef;
using sim::Vec3;
using sim::World;

SceneDef alone(const Vec3& velocity, const Vec3& spin) {
  SceneDef scene = empty_space();
  scene.boxes = {cube(1, {0, 0, 100})};
  scene.boxes[0].velocity = velocity;
  scene.boxes[0].spin = spin;
  return scene;
}

// Gravity and dt are chosen so that g·dt and every ½ (v₀ + v₁)·dt lie on the grids: x₀ + v t + ½ g t² to the bit, at
// every step.
TEST(Integrate, BallisticFlightIsExact) {
  SceneDef scene = alone({3, -2, 5}, {0, 0, 0});
  scene.world.gravity = {0.25, 0, -8};
  scene.world.dt = 1.0 / 64;
  World world = made(scene);
  for (int k = 1; k <= 320; ++k) {
    advance(world);
    const double t = k / 64.0;
    ASSERT_EQ(world.bodies().velocity[0], Vec3(3 + 0.25 * t, -2, 5 - 8 * t));
    ASSERT_EQ(world.bodies().position[0], Vec3(3 * t + 0.125 * t * t, -2 * t, 100 + 5 * t - 4 * t * t));
  }
}

// With the usual numbers only the rounding to the grids is left: a step adds at most half a grid step to velocity
// (2⁻³⁹) and to position (2⁻³⁷), and a wrong velocity is carried along.
TEST(Integrate, BallisticFlightIsExactToTheGridForAnyStep) {
  for (const double dt : {1.0 / 30, 1.0 / 300, 0.01}) {
    SceneDef scene = alone({1, 2, 20}, {0, 0, 0});
    scene.world.gravity = {0, 0, -9.81};
    scene.world.dt = dt;
    World world = made(scene);
    const int steps = static_cast<int>(4 / dt);
    for (int k = 0; k < steps; ++k) advance(world);
    const double t = steps * dt;
    const double bound = steps * (0x1p-37 + 0x1p-39 * t);
    EXPECT_NEAR(world.bodies().position.z[0], 100 + 20 * t - 0.5 * 9.81 * t * t, bound);
    EXPECT_NEAR(world.bodies().velocity.z[0], 20 - 9.81 * t, steps * 0x1p-39 + 1e-12);
  }
}

TEST(Integrate, FrozenAndStaticBodiesStay) {
  SceneDef scene = alone({0, 0, 0}, {0, 0, 0});
  scene.world.gravity = {0, 0, -9.81};
  scene.boxes.push_back(cube(2, {9, 0, 100}));
  scene.boxes[0].frozen = true;
  scene.boxes[1].is_static = true;
  World world = made(scene);
  for (int k = 0; k < 10; ++k) advance(world);
  EXPECT_EQ(world.bodies().position[0], Vec3(0, 0, 100));
  EXPECT_EQ(world.bodies().position[1], Vec3(9, 0, 100));
}

// Linear drag c: a step divides speed and spin by 1 + c·dt (backward Euler, stable at any c). Falling ends at g/c.
TEST(Integrate, AirDragSlowsFlightAndSpin) {
  SceneDef scene = alone({8, 0, 0}, {0, 4, 0});
  scene.world.air_drag = 0.5;
  scene.world.dt = 0.125;
  World world = made(scene);
  for (int k = 1; k <= 8; ++k) {
    advance(world);
    EXPECT_NEAR(world.bodies().velocity.x[0], 8 * std::pow(1.0625, -k), 1e-10);
    EXPECT_NEAR(world.bodies().spin.y[0], 4 * std::pow(1.0625, -k), 1e-10);
  }
  scene.world.gravity = {0, 0, -10};
  scene.boxes[0].position.z() = 5000;
  World falling = made(scene);
  for (int k = 0; k < 600; ++k) advance(falling);
  EXPECT_NEAR(falling.bodies().velocity.z[0], -20, 1e-9);
}

// A cube's spin never changes; each slow step turns it by the angle 2·atan(½ w dt) (Cayley) about the spin.
TEST(Integrate, CubeTurnsAboutItsSpin) {
  SceneDef scene = alone({0, 0, 0}, {0, 0, 1.5});
  scene.world.dt = 0.01;
  World world = made(scene);
  for (int k = 0; k < 100; ++k) advance(world);
  const double angle = 100 * 2 * std::atan(0.0075);
  EXPECT_EQ(world.bodies().spin[0], Vec3(0, 0, 1.5));
  EXPECT_NEAR(world.bodies().orientation.w[0], std::cos(angle / 2), 1e-13);
  EXPECT_NEAR(world.bodies().orientation.z[0], std::sin(angle / 2), 1e-13);
}

struct Spinner {
  Vec3 inertia, inverse;
  Quat q;
  Vec3 spin;

  Spinner(const Vec3& size, const Quat& orientation, const Vec3& spin_B)
      : inertia(sim::box_inertia(1, size)), inverse(inertia.cwiseInverse()), q(sim::normalised(orientation)) {
    spin = sim::VelocityGrid::round(to_world(axes_of(q), spin_B));
  }
  void turn(double dt) {
    const sim::Rotation next = sim::rotate_freely(q, spin, inertia, inverse, dt);
    q = next.orientation;
    spin = next.spin;
  }
  [[nodiscard]] Vec3 body_spin() const { return to_body(axes_of(q), spin); }
  [[nodiscard]] Vec3 momentum() const { return to_world(axes_of(q), body_spin().cwiseProduct(inertia)); }
  [[nodiscard]] double energy() const { return 0.5 * body_spin().dot(body_spin().cwiseProduct(inertia)); }
};

// 60 s of a 1 × 2 × 3 m box of 1 kg tumbling at about 4 rad/s, for small and large steps, and at 400 rad/s. Spin is
// rounded to 2⁻³⁸ each step, so the errors are a random walk of that (1e-10 at most was measured): momentum and energy
// stay within 1e-9 of what they were.
TEST(FreeRotation, KeepsAngularMomentumAndEnergyForAMinute) {
  for (const double dt : {1.0 / 300, 1.0 / 60, 1.0 / 30, 0.1}) {
    for (const double speed : {1.0, 100.0}) {
      Spinner body({1, 2, 3}, {0.7, 0.1, -0.5, 0.3}, Vec3(2, 3, -1.5) * speed);
      const Vec3 momentum = body.momentum();
      const double energy = body.energy();
      double drift = 0, gain = 0, loss = 0;
      for (double t = 0; t < 60; t += dt) {
        body.turn(dt);
        drift = std::max(drift, (body.momentum() - momentum).norm() / momentum.norm());
        gain = std::max(gain, body.energy() / energy - 1);
        loss = std::max(loss, 1 - body.energy() / energy);
      }
      EXPECT_LT(drift, 1e-9) << "dt " << dt << ", speed " << speed;
      EXPECT_LT(gain, 1e-9) << "dt " << dt << ", speed " << speed;
      EXPECT_LT(loss, 1e-9) << "dt " << dt << ", speed " << speed;
    }
  }
}

// A bar a hundred times as long as thick, round or flat, turning across its length: thousands of times as hard to turn
// that way as about itself, so an error of the middle spin would come back thousands of times as large. (6e-11
// measured.)
TEST(FreeRotation, KeepsABarTurningAcrossItsLength) {
  for (const Vec3& size : {Vec3(4, 0.04, 0.04), Vec3(0.08, 4, 0.04), Vec3(0.04, 0.08, 4)}) {
    for (const double dt : {1.0 / 300, 1.0 / 60, 1.0 / 30}) {
      Spinner body(size, {0.2, 0.6, -0.6, 0.4}, {4, 3, 5});
      const Vec3 momentum = body.momentum();
      const double energy = body.energy();
      for (double t = 0; t < 60; t += dt) body.turn(dt);
      EXPECT_LT((body.momentum() - momentum).norm() / momentum.norm(), 1e-9) << size.transpose() << ", dt " << dt;
      EXPECT_NEAR(body.energy() / energy, 1, 1e-9) << size.transpose() << ", dt " << dt;
    }
  }
}

// Dzhanibekov: spinning about the middle axis, ever so slightly disturbed, a box turns over again and again; about the
// longest or the shortest axis it does not. The middle moment of 1 × 2 × 3 m belongs to y.
TEST(FreeRotation, OnlyTheMiddleAxisTurnsOver) {
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 spin_B = Vec3::Constant(1e-3);
    spin_B[axis] = 5;
    Spinner body({1, 2, 3}, {1, 0.2, 0.1, 0.3}, spin_B);
    int turned_over = 0;
    double side = 1;
    for (int k = 0; k < 3600; ++k) {
      body.turn(1.0 / 60);
      const double along = body.body_spin()[axis] / 5;
      if (along * side < -0.9) {
        side = -side;
        ++turned_over;
      }
      EXPECT_TRUE(axis == 1 || along > 0.999) << "axis " << axis << " wanders: " << along;
    }
    EXPECT_EQ(turned_over > 5, axis == 1) << "axis " << axis << " turned over " << turned_over << " times";
  }
}

// A square column (Ixx = Iyy) spinning askew: its own axis circles the angular momentum L at |L| / Ixx, and turns over
// itself at the constant spin about z. After a second of slow turns, by angle ∝ dt², the second order of the midpoint
// rule.
TEST(FreeRotation, SymmetricTopPrecessesAtTheRateOfTheTextbook) {
  double last_error = 1;
  for (const double dt : {0.0125, 0.00625, 0.003125}) {
    Spinner body({1, 1, 3}, {0.9, 0.3, -0.2, 0.1}, {1.5, 0, 4});
    const Vec3 momentum = body.momentum(), axis = axes_of(body.q)[2];
    const double rate = momentum.norm() / body.inertia.x();
    const Vec3 wanted = Eigen::AngleAxisd(rate, momentum.normalized()) * axis;
    const int steps = static_cast<int>(std::lround(1 / dt));
    for (int k = 0; k < steps; ++k) body.turn(dt);
    const double error = (axes_of(body.q)[2] - wanted).norm();
    EXPECT_LT(error, 10 * dt * dt);
    EXPECT_LT(error, last_error / 3.5) << "a second-order rule errs a quarter as much at half the step";
    EXPECT_NEAR(body.body_spin().z(), 4, 1e-9);
    last_error = error;
  }
}

// The step moves a body exactly as rotate_freely and the ballistic rule say; spin with drag is not gyroscopic magic.
TEST(Integrate, UsesTheGyroscopicRotationForUnevenBoxes) {
  SceneDef scene = alone({0, 0, 0}, {2, 3, -1.5});
  scene.boxes[0].size = {1, 2, 3};
  World world = made(scene);
  const Vec3 inertia = world.bodies().inertia[0];
  EXPECT_EQ(inertia, Vec3((4.0 + 9) / 12, (1.0 + 9) / 12, (1.0 + 4) / 12)) << "m (b² + c²) / 12";
  const Vec3 momentum = world.bodies().spin[0].cwiseProduct(inertia);
  for (int k = 0; k < 600; ++k) advance(world);
  const Axes axes = axes_of(world.bodies().orientation[0]);
  const Vec3 now = to_world(axes, to_body(axes, world.bodies().spin[0]).cwiseProduct(inertia));
  EXPECT_LT((now - momentum).norm(), 1e-9);
  EXPECT_GT((world.bodies().spin[0] - Vec3(2, 3, -1.5)).norm(), 0.01) << "the spin itself must change";
}

TEST(Integrate, OrientationStaysAUnitQuaternion) {
  SceneDef scene = tumble_of_boxes(3, 2);
  scene.world = empty_space().world;
  World world = made(scene);
  for (int k = 0; k < 1000; ++k) advance(world);
  for (std::size_t i = 0; i < world.bodies().size(); ++i) {
    const Quat q = world.bodies().orientation[i];
    EXPECT_NEAR(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, 1, 1e-15);
  }
}

}  // namespace
}  // namespace tumble::test
