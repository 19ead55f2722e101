// A hit without restitution throws nothing back: neither what a tower carries, nor a tower that falls as one.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::SceneDef;
using sim::World;

constexpr double kHeights[] = {0, 0.022, 0.044, 0.066, 0.088};  // m more than 1: hits at other times of a step

// Cubes on top of each other without restitution, the first `standing` of them on the ground, the others 1 m + `more`
// higher.
SceneDef tower_of(int count, int standing, double more, double dt) {
  SceneDef scene = on_ground();
  scene.world.method = sim::Method::kLayered;
  scene.world.dt = dt;
  scene.world.substeps = 8;
  scene.world.freezing = false;
  scene.world.ground_material.restitution = 0;
  for (int k = 0; k < count; ++k) {
    sim::BoxDef box = cube(static_cast<sim::BodyId>(k) + 1, {0, 0, k + 0.5 + (k < standing ? 0 : 1 + more)});
    box.material.restitution = 0;
    scene.boxes.push_back(box);
  }
  return scene;
}

struct Thrown {
  double up = 0, sunk = 0;  // m/s, m, of any box: the most
};

Thrown after_the_hit(const SceneDef& scene) {
  World world = made(scene);
  Thrown thrown;
  for (int k = 0; k < static_cast<int>(1.5 / scene.world.dt); ++k) {
    advance(world);
    for (std::size_t i = 0; i < world.bodies().size(); ++i) {
      thrown.up = std::max(thrown.up, world.bodies().velocity.z[i]);
      thrown.sunk = std::max(thrown.sunk, static_cast<double>(i) + 0.5 - world.bodies().position.z[i]);
    }
  }
  return thrown;
}

// The mean speed, since much depends on when in a step the hit comes, and the deepest.
Thrown of_all_heights(int count, int standing, double dt) {
  Thrown all;
  for (const double more : kHeights) {
    const Thrown one = after_the_hit(tower_of(count, standing, more, dt));
    all.up += one.up / std::size(kHeights);
    all.sunk = std::max(all.sunk, one.sunk);
  }
  return all;
}

TEST(ThrowBack, ATowerThatFallsAsOneStays) {
  const Thrown three = of_all_heights(3, 0, 1.0 / 60), eight = of_all_heights(8, 0, 1.0 / 60);
  EXPECT_LT(three.up, 0.35);  // of 4.4 m/s
  EXPECT_LT(three.sunk, 0.015);
  EXPECT_LT(eight.up, 0.3);
  EXPECT_LT(eight.sunk, 0.035);
  EXPECT_LT(of_all_heights(8, 0, 1.0 / 240).up, 0.3);
}

TEST(ThrowBack, ATowerThatIsHitThrowsLittleUp) {
  for (const double dt : {1.0 / 60, 1.0 / 240}) {
    EXPECT_LT(of_all_heights(2, 1, dt).up, 0.15) << dt;
    EXPECT_LT(of_all_heights(4, 3, dt).up, 0.25) << dt;
    EXPECT_LT(of_all_heights(9, 8, dt).up, 0.25) << dt;
  }
}

}  // namespace
}  // namespace tumble::test
