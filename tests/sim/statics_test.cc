// Method layered: what friction can hold, and how what it cannot hold falls, against closed forms of statics.
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

constexpr double kGravity = 9.81;

struct Rate {
  double dt;
  std::uint32_t substeps;
};
constexpr Rate kRates[] = {{1.0 / 30, 4}, {1.0 / 60, 1}, {1.0 / 60, 8}, {1.0 / 240, 8}};

SceneDef scene_of(const Rate& rate, double friction) {
  SceneDef scene = on_ground();
  scene.world.method = sim::Method::kLayered;
  scene.world.dt = rate.dt;
  scene.world.substeps = rate.substeps;
  scene.world.freezing = false;
  scene.world.ground_material = {.friction = friction, .friction_dynamic = friction, .restitution = 0};
  return scene;
}

// A box that is turned about y: a point (x, z) of it lies at (x cos − z sin, x sin + z cos) from its centre.
struct Turned {
  double angle;  // rad, of its own z axis towards −x

  [[nodiscard]] Vec3 at(double x, double z) const {
    return {x * std::cos(angle) - z * std::sin(angle), 0, x * std::sin(angle) + z * std::cos(angle)};
  }
  [[nodiscard]] sim::BoxDef box_at(sim::BodyId id, const Vec3& size, const Vec3& position) const {
    sim::BoxDef out = box(id, size, position);
    out.orientation = {std::cos(angle / 2), 0, -std::sin(angle / 2), 0};
    return out;
  }
};

void add(SceneDef& scene, sim::BoxDef body, bool is_static) {
  body.is_static = is_static;
  body.material = scene.world.ground_material;
  scene.boxes.push_back(body);
}

World after(const SceneDef& scene, double seconds) {
  World world = made(scene);
  for (long k = std::lround(seconds / scene.world.dt); k > 0; --k) advance(world);
  return world;
}

// Both ends slip at once. The ground bears N = W / (1 + μ²), the wall μ N; their friction is μ N and μ² N.
TEST(Statics, ALadderStandsWhereBothFrictionsHoldIt) {
  const double length = 2, thickness = 0.05;
  for (const double friction : {0.2, 0.4, 0.6}) {
    for (const double part : {0.92, 0.98, 1.06, 1.1}) {
      const Turned ladder{part * std::atan(2 * friction / (1 - friction * friction))};
      const Vec3 top = ladder.at(-0.5 * thickness, 0.5 * length), foot = ladder.at(-0.5 * thickness, -0.5 * length);
      const double wide = foot.x() - top.x(), high = top.z() - foot.z(), bears = 1 / (1 + friction * friction);
      const double tips = foot.x() - friction * bears * (high + friction * wide);  // N m per newton of weight
      for (const Rate& rate : kRates) {
        SceneDef scene = scene_of(rate, friction);
        add(scene, box(1, {1, 2, 8}, {-0.5, 0, 4}), true);
        add(scene, ladder.box_at(2, {thickness, 0.5, length}, {-top.x(), 0, -foot.z()}), false);
        const double sunk = -foot.z() - after(scene, 2).state().bodies.position[1].z();
        EXPECT_EQ(sunk > 0.02, tips > 0) << friction << ", " << part << ", dt " << rate.dt << ", sunk " << sunk;
        if (tips < 0) {
          EXPECT_LT(sunk, 1e-5) << friction << ", " << part << ", dt " << rate.dt;
        }
      }
    }
  }
}

// A plank on a slope rests on one block and hangs under another, as far up again: they press with 2 and 1 times what
// its weight presses across the slope, so friction holds it with three times as much as on a plain slope.
TEST(Statics, APlankBetweenTwoBlocksIsHeldByBoth) {
  const Turned slope{-20 * std::numbers::pi / 180};
  const Vec3 centre(0, 0, 3);
  for (const double part : {0.9, 0.97, 1.05}) {  // of what friction can hold
    for (const Rate& rate : kRates) {
      SceneDef scene = scene_of(rate, std::tan(-slope.angle) / (3 * part));
      scene.world.ground = false;
      add(scene, slope.box_at(1, {0.02, 1, 0.5}, centre + slope.at(-1.01, -0.3)), true);
      add(scene, slope.box_at(2, {0.02, 1, 0.5}, centre + slope.at(-1.99, 0.3)), true);
      add(scene, slope.box_at(3, {6, 0.5, 0.1}, centre), false);
      const double slid = (after(scene, 1).state().bodies.position[2] - centre).norm();
      EXPECT_EQ(slid > 0.005, part > 1) << part << ", dt " << rate.dt << ", slid " << slid;
    }
  }
}

// The lean at which a box of that width and height has its centre of mass above its edge, rad.
double balance(double width, double height) { return std::atan2(width, height); }

// Seconds until a box that turns about its lower edge leans by `end`, beginning at rest with a lean of `start`.
double toppling_time(double width, double height, double start, double end) {
  constexpr double kStep = 1e-4;
  const double radius = 0.5 * std::hypot(width, height), pull = 0.75 * kGravity / radius;
  double lean = start - balance(width, height), speed = 0, time = 0;
  for (; lean < end - balance(width, height); time += kStep) {
    speed += kStep * pull * std::sin(lean);
    lean += kStep * speed;
  }
  return time;
}

TEST(Statics, ABoxTopplesAboutItsEdgeInTime) {
  constexpr double kRadians = std::numbers::pi / 180, kEnd = 60 * kRadians;
  struct Toppling {
    double width, height, beyond;  // m, m, degrees beyond the balance
  };
  for (const Toppling& t : {Toppling{0.5, 2, 2}, Toppling{0.5, 4, 0.5}, Toppling{0.9, 1, 2}}) {
    const double start = balance(t.width, t.height) + t.beyond * kRadians;
    const double wanted = toppling_time(t.width, t.height, start, kEnd);
    for (const Rate& rate : kRates) {
      const Turned leaning{-start};
      SceneDef scene = scene_of(rate, 1);
      const Vec3 edge = leaning.at(0.5 * t.width, -0.5 * t.height);
      add(scene, leaning.box_at(1, {t.width, 1, t.height}, -edge), false);
      World world = made(scene);
      double time = 0;
      for (; time < 5 && world.state().bodies.orientation.y[0] < std::sin(0.5 * kEnd); time += rate.dt) advance(world);
      EXPECT_NEAR(time, wanted, 0.02 * wanted + rate.dt) << t.width << " by " << t.height << ", dt " << rate.dt;
    }
  }
}

}  // namespace
}  // namespace tumble::test
