// A body that bounces waits where it was hit for the rest of a substep, but not while one that drives it on goes on.
#include <gtest/gtest.h>

#include <algorithm>

#include "src/collide/box_pair.h"
#include "tests/support/sim_scenes.h"
#include "tumble/sim/rotation.h"

namespace tumble::test {
namespace {

using sim::SceneDef;
using sim::World;

// A wall of bricks that bounce a little, and a cube of ten times their mass that flies at it.
SceneDef wall_and_cube(int substeps) {
  SceneDef scene = wall(5, 5);
  scene.world.method = sim::Method::kLayered;
  scene.world.dt = 1.0 / 60;
  scene.world.substeps = static_cast<std::uint32_t>(substeps);
  sim::BoxDef thrown = cube(scene.boxes.back().id + 1, {0, -3, 3});
  thrown.size = {2, 2, 2};
  thrown.mass = 20;
  thrown.velocity = {0, 25, 0};
  scene.boxes.push_back(thrown);
  return scene;
}

// The deepest overlap of the last body with another one, m.
double deepest_in_last(const sim::Bodies& bodies) {
  const auto frame = [&](std::size_t i) {
    return sim::BoxFrame{bodies.position[i], sim::axes_of(bodies.orientation[i]), bodies.half_extent[i]};
  };
  const std::size_t last = bodies.size() - 1;
  double deepest = 0;
  for (std::size_t i = 0; i < last; ++i) {
    deepest = std::max(deepest, -sim::BoxPair(frame(i), frame(last)).best(sim::kFaces | sim::kEdges).separation);
  }
  return deepest;
}

TEST(Waiting, NothingIsRunThroughWhileItWaits) {
  for (const int substeps : {2, 4, 8}) {
    World world = made(wall_and_cube(substeps));
    for (int k = 0; k < 40; ++k) {
      advance(world);
      EXPECT_LT(deepest_in_last(world.bodies()), 0.12) << substeps << " substeps, step " << k;
    }
  }
}

}  // namespace
}  // namespace tumble::test
