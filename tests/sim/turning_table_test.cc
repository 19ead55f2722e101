// What friction holds on a turning table goes round with it, method layered. Levers of contacts that stay as they are
// until the step ends tell such a crate to go on straight, and it creeps outward.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::SceneDef;
using sim::Vec3;
using sim::World;

constexpr double kRadius = 2, kPace = 1, kSeconds = 4;  // m, rad/s, s
constexpr double kNeeded = kRadius * kPace * kPace / 9.81;

struct Steps {
  double dt;
  std::uint32_t substeps;
};

// A table that turns about its middle on ice, and crates on it that turn with it; crate 2 stands beside the axis, and
// `stacked` ones on top of it.
SceneDef table(double table_mass, double friction, const Steps& steps, int stacked) {
  SceneDef scene = on_ground();
  scene.world.method = sim::Method::kLayered;
  scene.world.dt = steps.dt;
  scene.world.substeps = steps.substeps;
  scene.world.freezing = false;
  scene.world.ground_material.friction = scene.world.ground_material.friction_dynamic = 0;
  sim::BoxDef plate = box(1, {6, 6, 0.5}, {0, 0, 0.25});
  plate.mass = table_mass;
  plate.spin = {0, 0, kPace};
  scene.boxes = {plate};
  for (int k = 0; k <= stacked; ++k) {
    sim::BoxDef crate = box(static_cast<sim::BodyId>(k) + 2, {0.5, 0.5, 0.5}, {kRadius, 0, 0.75 + 0.5 * k});
    crate.mass = 10;
    crate.velocity = {0, kRadius * kPace, 0};
    crate.spin = {0, 0, kPace};
    scene.boxes.push_back(crate);
  }
  for (sim::BoxDef& of : scene.boxes) {
    of.material.friction = of.material.friction_dynamic = friction;
    of.material.restitution = 0;
  }
  return scene;
}

World after(const SceneDef& scene, double seconds) {
  World world = made(scene);
  for (double t = 0; t < seconds - scene.world.dt / 2; t += scene.world.dt) advance(world);
  return world;
}

constexpr Steps kSteps[] = {{1.0 / 60, 8}, {1.0 / 60, 1}, {1.0 / 30, 8}, {1.0 / 240, 2}};

TEST(TurningTable, CarriesACrateAlongACircle) {
  for (const Steps& steps : kSteps) {
    const World world = after(table(1e6, 2 * kNeeded, steps, 0), kSeconds);
    const Vec3 place = world.state().bodies.position[1], middle = world.state().bodies.position[0];
    const double angle = std::atan2(place.y() - middle.y(), place.x() - middle.x());
    EXPECT_NEAR(std::hypot(place.x() - middle.x(), place.y() - middle.y()), kRadius, 0.0005) << steps.dt;
    EXPECT_NEAR(std::remainder(angle - kPace * kSeconds, 2 * std::acos(-1.0)), 0, 0.001) << steps.dt;
  }
}

TEST(TurningTable, CarriesAStackAlongACircle) {
  const World world = after(table(1e6, 3 * kNeeded, {1.0 / 60, 8}, 2), kSeconds);
  for (std::size_t i = 1; i <= 3; ++i) {
    const Vec3 place = world.state().bodies.position[i];
    EXPECT_NEAR(std::hypot(place.x(), place.y()), kRadius, 0.002) << i;
  }
}

TEST(TurningTable, KeepsItsEnergyWhereItIsAsLightAsTheCrate) {
  const SceneDef scene = table(20, 3 * kNeeded, {1.0 / 60, 8}, 0);
  const auto energy = [](const World& world) {
    const sim::Bodies& bodies = world.state().bodies;
    double sum = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const Vec3 v = bodies.velocity[i];
      sum +=
          0.5 * bodies.mass[i] * sim::dot(v, v) + 0.5 * bodies.inertia[i].z() * bodies.spin[i].z() * bodies.spin[i].z();
    }
    return sum;
  };
  EXPECT_NEAR(energy(after(scene, kSeconds)) / energy(made(scene)), 1, 0.001);
}

TEST(TurningTable, LosesACrateThatItCannotHold) {
  const World world = after(table(1e6, 0.8 * kNeeded, {1.0 / 60, 8}, 0), kSeconds);
  const Vec3 place = world.state().bodies.position[1];
  EXPECT_GT(std::hypot(place.x(), place.y()), 1.2 * kRadius);
}

}  // namespace
}  // namespace tumble::test
