// The time for which a body has rested: an input, or a neighbour that does not rest, starts it anew, so that nothing
// falls asleep in the step in which its support goes.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::SceneDef;
using sim::Vec3;
using sim::World;

constexpr double kDt = 1.0 / 60;
constexpr double kGravity = 9.81;
constexpr sim::BodyId kSupport = 1, kPlank = 2, kWeight = 3;

SceneDef scene_of(sim::Method method) {
  SceneDef scene;
  scene.world.method = method;
  scene.world.dt = kDt;
  scene.world.substeps = 8;
  scene.world.freeze_time = 0.5;
  return scene;
}

// A plank whose centre lies 0.3 m outside its static support; a counterweight of 300 kg holds it.
SceneDef held_plank(sim::Method method) {
  SceneDef scene = scene_of(method);
  scene.boxes = {cube(kSupport, {0, 0, 0.5}), cube(kPlank, {0.8, 0, 1.1}), cube(kWeight, {0, 0, 1.45})};
  scene.boxes[0].is_static = true;
  scene.boxes[1].size = {2.6, 1, 0.2};
  scene.boxes[1].mass = 10;
  scene.boxes[2].size = {0.5, 0.5, 0.5};
  scene.boxes[2].mass = 300;
  return scene;
}

void advance_by(World& world, int steps) {
  for (int k = 0; k < steps; ++k) advance(world);
}

// m, of a body's centre
double height(const World& world, sim::BodyId id) { return world.bodies().position[*world.bodies().find(id)].z(); }

class RestTime : public testing::TestWithParam<sim::Method> {};
INSTANTIATE_TEST_SUITE_P(Methods, RestTime, testing::Values(sim::Method::kThesis, sim::Method::kLayered));

// Gravity tilts by 30° in the step in which a crate has rested for as long as it takes to fall asleep, and in those
// around it: friction 0.4 does not hold the crate.
TEST_P(RestTime, CratesSlideWhereGravityTilts) {
  const Vec3 tilted = {0.5 * kGravity, 0, -std::sqrt(0.75) * kGravity};
  const double way = 0.5 * (tilted.x() + 0.4 * tilted.z());  // m, of one second
  for (int step = 27; step <= 33; ++step) {
    SceneDef scene = scene_of(GetParam());
    scene.boxes = {cube(kPlank, {0, 0, 0.5})};
    World world = made(scene);
    advance_by(world, step);
    give(world, sim::SetGravity{tilted});
    advance_by(world, 60);
    EXPECT_NEAR(world.bodies().position[0].x(), way, 0.05) << step;
  }
}

// The weight is taken away after any time of rest.
TEST_P(RestTime, APlankTipsWhereItsCounterweightIsRemoved) {
  for (int step = 27; step <= 33; ++step) {
    SceneDef scene = held_plank(GetParam());
    scene.boxes[2].spin = {0, 0, 0.25};
    World world = made(scene);
    advance_by(world, step);
    give(world, sim::Remove{kWeight});
    advance_by(world, 60);
    EXPECT_LT(height(world, kPlank), 1.0) << step;
  }
}

// What touches a body that does not rest has rested for a step, what touches that for two.
TEST(RestTimeLayered, NeighboursOfABodyThatTurnsHaveNotRested) {
  SceneDef scene = scene_of(sim::Method::kLayered);
  scene.boxes = {cube(1, {0, 0, 0.5}), cube(2, {0, 0, 1.5}), cube(3, {0, 0, 2.5}), cube(4, {5, 0, 0.5})};
  scene.boxes[2].material.friction = scene.boxes[2].material.friction_dynamic = 0;
  scene.boxes[2].spin = {0, 0, 1};
  World world = made(scene);
  advance_by(world, 120);
  const std::vector<double>& time = world.bodies().low_energy_time;
  EXPECT_EQ(time[2], 0);
  EXPECT_DOUBLE_EQ(time[1], kDt);
  EXPECT_DOUBLE_EQ(time[0], 2 * kDt);
  EXPECT_EQ(world.bodies().frozen, (std::vector<std::uint8_t>{0, 0, 0, 1}));
}

}  // namespace
}  // namespace tumble::test
