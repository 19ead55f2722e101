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

// Of the energy, the most that is gained and lost by the end of any step.
struct Change {
  double gained = 0, lost = 0;
};
Change change_of(const SceneDef& scene) {
  World world = made(scene);
  const double before = sim::kinetic_energy(world.bodies(), 0);
  Change change;
  for (int k = 0; k < 60; ++k) {
    advance(world);
    const double part = sim::kinetic_energy(world.bodies(), 0) / before - 1;
    change.gained = std::fmax(change.gained, part);
    change.lost = std::fmax(change.lost, -part);
  }
  return change;
}

// A box that one wall drives back into another one may lose a little (take_back_gifts), but gains nothing.
TEST(CornerBounce, EnergyStays) {
  for (int walls = 1; walls <= 3; ++walls) {
    Random random(7);
    int lose = 0;
    Change most;
    for (int k = 0; k < 200; ++k) {
      const Change change = change_of(corner(walls, random));
      most = {std::fmax(most.gained, change.gained), std::fmax(most.lost, change.lost)};
      lose += change.lost > 1e-6 ? 1 : 0;
    }
    EXPECT_LT(most.gained, 1e-6) << walls << " walls";
    EXPECT_LE(lose, walls < 3 ? 0 : 2) << walls << " walls";
    EXPECT_LT(most.lost, 0.002) << walls << " walls";
  }
}

}  // namespace
}  // namespace tumble::test
