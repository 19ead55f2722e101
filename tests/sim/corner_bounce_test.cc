// Full restitution without friction keeps the energy, in corners too: a wall that a body does not touch takes no part
// in its bounce, and walls that it touches at one time give back all that they took.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/sim_scenes.h"
#include "tumble/sim/world_state.h"

namespace tumble::test {
namespace {

using sim::SceneDef;
using sim::Vec3;
using sim::World;

// A cube in the inner corner of `walls` static walls, flying and turning towards them.
SceneDef corner(int walls, Random& random) {
  SceneDef scene = empty_space();
  scene.world.method = sim::Method::kLayered;
  scene.world.dt = 1 / std::floor(random.uniform(60, 240));
  const double half = 0.1 + random.uniform(0, 0.3), far = 4;
  scene.boxes = {cube(1, random_vector(random, half) - Vec3(3, 3, 3) * half)};
  scene.boxes[0].size = Vec3(2, 2, 2) * half;
  scene.boxes[0].orientation = random.rotation();
  scene.boxes[0].velocity = Vec3(2, 2, 2) + random_vector(random, 2);
  scene.boxes[0].spin = random_vector(random, 8);
  for (int axis = 0; axis < walls; ++axis) {
    Vec3 size(2 * far, 2 * far, 2 * far), place = Vec3::Zero();
    size[axis] = 2;
    place[axis] = 1;
    scene.boxes.push_back(box(static_cast<sim::BodyId>(axis) + 2, size, place));
    scene.boxes.back().is_static = true;
  }
  for (sim::BoxDef& b : scene.boxes) b.material = {0, 0, 1};
  return scene;
}

// Of the energy, the most that a step changes.
double most_change(const SceneDef& scene) {
  World world = made(scene);
  const double before = sim::kinetic_energy(world.bodies(), 0);
  double most = 0;
  for (int k = 0; k < 60; ++k) {
    advance(world);
    most = std::fmax(most, std::fabs(sim::kinetic_energy(world.bodies(), 0) / before - 1));
  }
  return most;
}

TEST(CornerBounce, EnergyStays) {
  for (int walls = 1; walls <= 3; ++walls) {
    Random random(7);
    int lost = 0;
    double most = 0;
    for (int k = 0; k < 200; ++k) {
      const double change = most_change(corner(walls, random));
      most = std::fmax(most, change);
      lost += change > 1e-6 ? 1 : 0;
    }
    EXPECT_EQ(lost, 0) << walls << " walls, at most " << most;
  }
}

}  // namespace
}  // namespace tumble::test
