// Free rotation: the angle of a turn, at any speed, shape, step and number of substeps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "src/math/half_turn.h"
#include "src/model/mass.h"
#include "src/world/free_flight.h"
#include "tests/support/sim_scenes.h"
#include "tumble/sim/transform.h"

namespace tumble::test {
namespace {

using sim::Quat;
using sim::Transform;
using sim::Vec3;

constexpr double kWithin = 1e-3;  // of the angle turned

// The angle between two orientations, rad.
double angle_between(const Quat& a, const Quat& b) {
  const Quat d = sim::product({a.w, -a.x, -a.y, -a.z}, b);
  return 2 * std::asin(std::min(1.0, std::sqrt((d.x * d.x + d.y * d.y) + d.z * d.z)));
}

Quat about(const Vec3& axis, double angle) {
  const double s = std::sin(0.5 * angle);
  return {std::cos(0.5 * angle), axis.x() * s, axis.y() * s, axis.z() * s};
}

Vec3 direction(Random& random) {
  const Vec3 v = random_vector(random, 1);
  return v / v.norm();
}

// Uniform in the logarithm.
double magnitude(Random& random, double low, double high) {
  return std::exp(random.uniform(std::log(low), std::log(high)));
}

TEST(HalfTurn, TurnsByTheAngleUpToTheFastestSpin) {
  Random random(1);
  const Vec3 axis = direction(random);
  for (int k = 0; k < 20000; ++k) {
    const double angle = k % 2 == 0 ? magnitude(random, 1e-9, 14200) : random.uniform(0, 14200);
    const double off = angle_between(sim::turned({}, axis * (0.5 * angle)), about(axis, angle));
    ASSERT_LE(off, angle <= 0.0625 ? angle * 3.4e-4 : 1e-11) << "angle " << angle;
  }
}

TEST(HalfTurn, MeetsNoPole) {
  const double pi = std::acos(-1.0);
  for (int k = 1; k < 100; ++k) {
    for (const double near : {-1e-3, -1e-9, 0.0, 1e-9, 1e-3}) {
      const double angle = k * pi + near;
      EXPECT_LE(angle_between(sim::turned({}, {0, 0.5 * angle, 0}), about({0, 1, 0}, angle)), 1e-12) << angle;
    }
  }
}

struct Body {
  Vec3 inertia, inverse;
  Quat q;
  Vec3 spin;

  Body(const Vec3& size, const Quat& orientation, const Vec3& spin_W)
      : inertia(sim::box_inertia(1, size)), inverse(inertia.cwiseInverse()), q(orientation), spin(spin_W) {}
  [[nodiscard]] Quat turned(double dt) const { return sim::rotate_freely(q, spin, inertia, inverse, dt).orientation; }
};

// The orientation after dt, by the classical Runge-Kutta method on Euler's equations in steps of 5 mrad.
Quat exact(const Body& body, double dt) {
  struct State {
    double v[7];  // w, x, y, z, angular velocity about the body's own axes
  };
  const Vec3 spin = sim::to_body(sim::axes_of(body.q), body.spin), &inertia = body.inertia;
  State s = {{body.q.w, body.q.x, body.q.y, body.q.z, spin.x(), spin.y(), spin.z()}};
  const auto rate = [&](const State& at) {
    const double* v = at.v;
    const Quat d = sim::product({v[0], v[1], v[2], v[3]}, {0, v[4], v[5], v[6]});
    return State{{0.5 * d.w, 0.5 * d.x, 0.5 * d.y, 0.5 * d.z, v[5] * v[6] * (inertia.y() - inertia.z()) / inertia.x(),
                  v[6] * v[4] * (inertia.z() - inertia.x()) / inertia.y(),
                  v[4] * v[5] * (inertia.x() - inertia.y()) / inertia.z()}};
  };
  const auto moved = [](const State& at, const State& by, double h) {
    State to = at;
    for (int k = 0; k < 7; ++k) to.v[k] += h * by.v[k];
    return to;
  };
  const int steps = 1 + static_cast<int>(body.spin.norm() * dt / 0.005);
  const double h = dt / steps;
  for (int k = 0; k < steps; ++k) {
    const State a = rate(s), b = rate(moved(s, a, h / 2)), c = rate(moved(s, b, h / 2)), d = rate(moved(s, c, h));
    s = moved(moved(moved(moved(s, a, h / 6), b, h / 3), c, h / 3), d, h / 6);
  }
  return sim::normalised({s.v[0], s.v[1], s.v[2], s.v[3]});
}

// Random boxes up to 1 : 50, cubes among them, at up to 1000 rad/s about any axis. Turns of more than two rounds are
// left to the tests of principal axes: there the reference is a formula.
TEST(FreeRotation, FollowsEulersEquationsForAnyShapeAndStep) {
  Random random(2);
  double worst = 0;
  for (int k = 0; k < 600; ++k) {
    Vec3 size(magnitude(random, 1, 50), magnitude(random, 1, 50), magnitude(random, 1, 50));
    if (k % 4 == 0) size = Vec3(size.x(), size.x(), size.x() * (1 + 0.001 * (k % 3)));
    const double speed = magnitude(random, 0.1, 1000), turn = magnitude(random, 1e-3, 17),
                 dt = std::min(1.0, turn / speed);
    const Body body(size, sim::normalised(random.rotation()), direction(random) * speed);
    const double off = angle_between(body.turned(dt), exact(body, dt)) / (speed * dt);
    worst = std::max(worst, off);
    ASSERT_LE(off, kWithin) << size.transpose() << ", " << speed << " rad/s, dt " << dt;
  }
  EXPECT_GT(worst, 1e-6) << "nothing was compared";
}

constexpr double kSpeeds[] = {0.5, 3.0, 20.0, 100.0, 1000.0};  // rad/s

// A step of a body alone that spins about −z, one of its own axes.
void expect_spin_times_time(sim::SceneDef scene, const Vec3& size, double speed) {
  SCOPED_TRACE(testing::Message() << "size " << size.transpose() << ", dt " << scene.world.dt << ", substeps "
                                  << scene.world.substeps << ", " << speed << " rad/s");
  scene.boxes = {box(1, size, {0, 0, 0})};
  scene.boxes[0].spin = {0, 0, -speed};
  const double turn = speed * scene.world.dt;
  sim::World world = made(scene);
  advance(world);
  EXPECT_LE(angle_between(world.bodies().orientation[0], about({0, 0, -1}, turn)), 0.5 * kWithin * turn);
  EXPECT_EQ(world.bodies().spin[0], Vec3(0, 0, -speed));
}

// About its own axes a body turns by spin times time, whatever its shape: every step, number of substeps and method.
TEST(FreeRotation, TurnsBySpinTimesTimeInEveryStepOfBothMethods) {
  sim::SceneDef scene = empty_space();
  for (const sim::Method method : {sim::Method::kThesis, sim::Method::kLayered}) {
    scene.world.method = method;
    for (const double dt : {1e-5, 1.0 / 1000, 1.0 / 60, 1.0 / 30, 1.0}) {
      for (const std::uint32_t substeps : {1U, 7U, 64U}) {
        scene.world.dt = dt;
        scene.world.substeps = substeps;
        for (const Vec3& size :
             {Vec3(1, 1, 1), Vec3(1, 1, 1.001), Vec3(1, 2, 3), Vec3(8, 0.1, 0.1), Vec3(0.05, 3, 3)}) {
          for (const double speed : kSpeeds) expect_spin_times_time(scene, size, speed);
        }
      }
    }
  }
}

// Parts of at most a quarter radian err by the fourth power of the step.
TEST(FreeRotation, FastTurnsConvergeToTheFourthOrder) {
  const Body body({1, 2, 3}, {0.9, 0.3, -0.2, 0.1}, {1.5, 2, 4});
  const double whole = 0.5;
  const Quat wanted = exact({{1, 2, 3}, sim::normalised(body.q), body.spin}, whole);
  double last = 0;
  for (const int steps : {10, 20}) {
    Body turning({1, 2, 3}, sim::normalised(body.q), body.spin);
    for (int k = 0; k < steps; ++k) {
      const sim::Rotation next =
          sim::rotate_freely(turning.q, turning.spin, turning.inertia, turning.inverse, whole / steps);
      turning.q = next.orientation;
      turning.spin = next.spin;
    }
    const double error = angle_between(turning.q, wanted);
    if (last > 0) {
      EXPECT_LT(error, last / 12);
    }
    last = error;
  }
  EXPECT_LT(last, 1e-5);
}

// Every turn of a mirrored or swapped body is the mirrored or swapped turn, to the bit.
TEST(FreeRotation, OfAnImageIsTheImageAtAnySpeed) {
  Random random(3);
  const std::vector<Transform> transforms = {
      {.mirror_x = true}, {.mirror_y = true}, {.swap_xy = true}, {.mirror_x = true, .swap_xy = true}};
  for (int k = 0; k < 2000; ++k) {
    const Vec3 size(random.uniform(0.1, 3), random.uniform(0.1, 3), random.uniform(0.1, 3));
    const Vec3 spin = direction(random) * magnitude(random, 0.1, 1000);
    const Body body(k % 3 == 0 ? Vec3(1, 1, 1) : size, sim::normalised(random.rotation()), spin);
    const double dt = magnitude(random, 1e-4, 0.1);
    const sim::Rotation turn = sim::rotate_freely(body.q, body.spin, body.inertia, body.inverse, dt);
    for (const Transform& transform : transforms) {
      const sim::Rotation image =
          sim::rotate_freely(transform.orientation(body.q), transform.axial_vector(body.spin),
                             transform.extents(body.inertia), transform.extents(body.inverse), dt);
      ASSERT_EQ(image.orientation, transform.orientation(turn.orientation)) << k << ": " << to_string(transform);
      ASSERT_EQ(image.spin, transform.axial_vector(turn.spin)) << k << ": " << to_string(transform);
    }
  }
}

}  // namespace
}  // namespace tumble::test
