// Method layered: overlaps end without speed, thin plates lie on the ground, and rubble comes to rest.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "src/world/scratch.h"
#include "tests/support/sim_scenes.h"
#include "tumble/sim/world_state.h"

namespace tumble::test {
namespace {

using sim::Vec3;

constexpr int kScenes = 500;
constexpr int kSeconds5 = 300;         // steps
constexpr double kEnergyMax = 1e-6;    // J/kg
constexpr double kOverlapMax = 0.005;  // m, left of overlaps of up to 0.7 m

// 2 to 8 boxes in one place, at rest.
sim::SceneDef overlapping(std::uint64_t seed) {
  Random random(seed);
  sim::SceneDef scene = empty_space();
  scene.world.method = sim::Method::kLayered;
  scene.world.substeps = 8;
  scene.world.freezing = seed % 2 == 0;
  const double friction = seed % 3 == 0 ? 0 : 0.4, restitution = seed % 5 == 0 ? 0.5 : 0;
  for (sim::BodyId id = 1; id <= 2 + seed % 7; ++id) {
    const double x = random.uniform(0.2, 1.2), y = random.uniform(0.2, 1.2);
    sim::BoxDef body = box(id, {x, y, random.uniform(0.2, 1.2)}, random_vector(random, 0.5) + Vec3(0, 0, 5));
    body.material.friction = body.material.friction_dynamic = friction;
    body.material.restitution = restitution;
    body.orientation = sim::normalised(random.rotation());
    scene.boxes.push_back(body);
  }
  return scene;
}

double deepest_overlap(const sim::World& world) {
  double deepest = 0;
  for (const sim::ManifoldPoint& point : world.scratch().manifold_points) {
    deepest = std::max(deepest, -point.separation);
  }
  return deepest;
}

TEST(Overlaps, BoxesThatOverlapAtRestPartAndStayAtRest) {
  int deep = 0;
  for (std::uint64_t seed = 0; seed < kScenes; ++seed) {
    sim::World world = made(overlapping(seed));
    for (int k = 0; k < kSeconds5; ++k) {
      advance(world);
      if (k == 0 && deepest_overlap(world) > 0.1) ++deep;
    }
    double mass = 0;
    for (const double m : world.bodies().mass) mass += m;
    ASSERT_LE(sim::total_energy(world.state()).kinetic, kEnergyMax * mass) << "seed " << seed;
    ASSERT_LE(deepest_overlap(world), kOverlapMax) << "seed " << seed;
  }
  EXPECT_GT(deep, kScenes / 2);
}

// A box that starts in the ground is lifted out of it, and brings no speed along.
TEST(Overlaps, ABoxInTheGroundComesOutWithoutAJump) {
  for (const double deep : {0.002, 0.02, 0.2}) {
    sim::SceneDef scene = on_ground();
    scene.world.method = sim::Method::kLayered;
    scene.boxes = {cube(1, {0, 0, 0.5 - deep})};
    sim::World world = made(scene);
    for (int k = 0; k < kSeconds5; ++k) {
      advance(world);
      ASSERT_LE(world.bodies().position.z[0], 0.5 + 1e-9) << deep;
    }
    EXPECT_GE(world.bodies().position.z[0], 0.5 - 0.0006) << deep;
  }
}

TEST(Overlaps, APlateThinnerThanTheSlopLiesOnTheGround) {
  for (const double thickness : {0.002, 0.0005, 0.0002}) {
    for (const double height : {0.0, 0.01, 0.5}) {
      sim::SceneDef scene = on_ground();
      scene.world.method = sim::Method::kLayered;
      scene.world.freezing = false;
      scene.boxes = {box(1, {1, 0.7, thickness}, {0, 0, 0.5 * thickness + height})};
      sim::World world = made(scene);
      for (int k = 0; k < kSeconds5; ++k) advance(world);
      EXPECT_NEAR(world.bodies().position.z[0], 0.5 * thickness, 0.05 * thickness + 0.0001 * (height > 0 ? 1 : 0))
          << thickness << " m thick, from " << height << " m";
    }
  }
}

// bench/scenes/brick_wall.toml, for twice its time.
TEST(Overlaps, TheRubbleOfAWallSleepsByTenSeconds) {
  sim::SceneDef scene = wall(17, 13);
  scene.world.method = sim::Method::kLayered;
  scene.world.substeps = 2;
  add_thrown_cube(scene);
  sim::World world = made(scene);
  for (int k = 0; k < 2 * kSeconds5; ++k) advance(world);
  const auto& frozen = world.bodies().frozen;
  EXPECT_GE(10 * std::ranges::count(frozen, 1), 9 * static_cast<std::ptrdiff_t>(frozen.size()));
}

}  // namespace
}  // namespace tumble::test
