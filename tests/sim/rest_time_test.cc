// The time for which a body has rested: an input, or a neighbour that does not rest, starts it anew, so that nothing
// falls asleep in the step in which its support goes.
#include <gtest/gtest.h>

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

// Gravity turns sideways in the step in which a crate has rested for as long as it takes to fall asleep, and in those
// around it: nothing presses the crate on the ground any more, so it falls along it.
TEST_P(RestTime, BodiesFallWhereGravityTurns) {
  for (int step = 27; step <= 33; ++step) {
    SceneDef scene = scene_of(GetParam());
    scene.boxes = {cube(kPlank, {0, 0, 0.5})};
    World world = made(scene);
    advance_by(world, step);
    give(world, sim::SetGravity{{kGravity, 0, 0}});
    advance_by(world, 60);
    EXPECT_NEAR(world.bodies().position[0].x(), 0.5 * kGravity, 0.1) << step;
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

TEST(RestTimeLayered, APlankTipsWhereItsCounterweightTurnedAndIsThrownUp) {
  for (const bool by_speed : {false, true}) {
    SceneDef scene = held_plank(sim::Method::kLayered);
    World world = made(scene);
    for (int k = 0; k < 120; ++k) {  // the weight never rests
      give(world, sim::SetVelocity{kWeight, {0, 0, 0}, {0, 0, k % 2 == 0 ? 2.0 : -2.0}});
      advance(world);
    }
    if (by_speed) {
      give(world, sim::SetVelocity{kWeight, {0, 0, 12}, {0, 0, 0}});
    } else {
      give(world, sim::Push{kWeight, {0, 0, 3600}, true, {0, 0, 0}});
    }
    advance_by(world, 60);
    EXPECT_LT(height(world, kPlank), 1.0) << by_speed;
  }
}

}  // namespace
}  // namespace tumble::test
