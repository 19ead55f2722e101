// Method layered: what would not stay where it is does not fall asleep, and what is put against a sleeper wakes it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "src/world/scratch.h"
#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::BodyIndex;
using sim::SceneDef;
using sim::Vec3;
using sim::World;

constexpr double kDt = 1.0 / 60;
constexpr int kSecond = 60;  // steps

SceneDef scene_of(std::uint32_t substeps) {
  SceneDef scene = on_ground();
  scene.world.method = sim::Method::kLayered;
  scene.world.dt = kDt;
  scene.world.substeps = substeps;
  return scene;
}

void run(World& world, int steps) {
  for (int k = 0; k < steps; ++k) advance(world);
}

void set_material(SceneDef& scene, double friction) {
  for (sim::BoxDef& of : scene.boxes) of.material = {friction, friction, 0};
  scene.world.ground_material = {friction, friction, 0};
}

// A plank of 1 kg on the edge of a static block, and a crate on it that takes their common centre of mass `beyond` the
// edge, m.
SceneDef plank_over_edge(std::uint32_t substeps, double crate, double beyond) {
  SceneDef scene = scene_of(substeps);
  const double plank_x = -0.3;
  scene.boxes = {cube(1, {-1, 0, 0.5}), cube(2, {plank_x, 0, 1.1}), cube(3, {0, 0, 1.4})};
  scene.boxes[0].size = {2, 2, 1};
  scene.boxes[0].is_static = true;
  scene.boxes[1].size = {2, 1, 0.2};
  scene.boxes[2].size = {0.4, 0.4, 0.4};
  scene.boxes[2].mass = crate;
  scene.boxes[2].position.x() = (beyond * (1 + crate) - plank_x) / crate;
  set_material(scene, 0.8);
  return scene;
}

// A light body under a heavy one tips at an even speed of some millimetres a second at first.
TEST(FallingAsleep, APlankThatTipsUnderACrateDoesNot) {
  for (const std::uint32_t substeps : {1U, 2U, 4U, 8U}) {
    for (const double crate : {1.0, 3.0, 10.0, 100.0}) {
      for (const double beyond : {0.01, 0.02}) {
        World world = made(plank_over_edge(substeps, crate, beyond));
        run(world, 10 * kSecond);
        EXPECT_LT(world.bodies().position[2].z(), 1.2) << substeps << ", " << crate << " kg, " << beyond << " m";
      }
    }
  }
}

TEST(FallingAsleep, APlankOnTheEdgeThatBearsItsCrateDoes) {
  for (const std::uint32_t substeps : {1U, 4U}) {
    for (const double crate : {1.0, 10.0}) {
      World world = made(plank_over_edge(substeps, crate, -0.02));
      run(world, 2 * kSecond);
      EXPECT_EQ(world.bodies().frozen, (std::vector<std::uint8_t>{0, 1, 1})) << substeps << ", " << crate << " kg";
    }
  }
}

// 1, 100, 1 and 100 kg, 0.1 m deep in one another: they part, lean, and fall some seconds later.
TEST(FallingAsleep, ATowerThatLeansMoreAndMoreDoesNot) {
  SceneDef scene = scene_of(8);
  for (std::uint32_t k = 0; k < 4; ++k) {
    scene.boxes.push_back(cube(k + 1, {k % 2 == 0 ? 0.0 : 0.1, 0, 0.4 + 0.9 * k}));
    scene.boxes.back().mass = k % 2 == 0 ? 1 : 100;
  }
  World world = made(scene);
  run(world, 10 * kSecond);
  EXPECT_LT(world.bodies().position[3].z(), 3);
  EXPECT_EQ(world.bodies().frozen, (std::vector<std::uint8_t>{1, 1, 1, 1}));
}

constexpr int kInShaft = 24;

// Boxes of 1 and of 1000 kg that fall into a shaft.
SceneDef shaft(std::uint64_t seed) {
  SceneDef scene = scene_of(8);
  Random random(seed);
  for (const Vec3& at : {Vec3(-1.6, 0, 20), Vec3(1.6, 0, 20), Vec3(0, -1.6, 20), Vec3(0, 1.6, 20)}) {
    scene.boxes.push_back(cube(scene.boxes.size() + 1, at));
    scene.boxes.back().size = at.y() == 0 ? Vec3(0.2, 6, 40) : Vec3(3, 0.2, 40);
    scene.boxes.back().is_static = true;
  }
  for (int k = 0; k < kInShaft; ++k) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    scene.boxes.push_back(cube(scene.boxes.size() + 1, {x, y, 0.6 + 0.9 * k}));
    scene.boxes.back().size = {0.5, 0.5, 0.5};
    scene.boxes.back().orientation = sim::normalised(random.rotation());
    scene.boxes.back().mass = random.uniform(0, 1) < 0.5 ? 1 : 1000;
  }
  return scene;
}

// m, the deepest overlap that a body has in the step in which it falls asleep.
double deepest_asleep(World& world, int steps) {
  double deepest = 0;
  for (int k = 0; k < steps; ++k) {
    const std::vector<std::uint8_t> before = world.bodies().frozen;
    advance(world);
    const auto fell = [&](BodyIndex i) { return i != sim::kGround && world.bodies().frozen[i] > before[i]; };
    for (const sim::Manifold& m : world.scratch().manifolds) {
      if (!fell(m.a) && !fell(m.b)) continue;
      for (const sim::ManifoldPoint& p : points_of(world.scratch(), m)) deepest = std::max(deepest, -p.separation);
    }
  }
  return deepest;
}

TEST(FallingAsleep, WhatPartsDoesNot) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 5U, 8U, 9U, 10U}) {
    World world = made(shaft(seed));
    EXPECT_LE(deepest_asleep(world, 6 * kSecond), 0.005) << seed;
  }
}

TEST(FallingAsleep, WhatHasPartedDoes) {
  for (const std::uint64_t seed : {6U}) {
    World world = made(shaft(seed));
    EXPECT_LE(deepest_asleep(world, 5 * kSecond), 0.002) << seed;
    EXPECT_EQ(std::ranges::count(world.bodies().frozen, 1), kInShaft) << seed;
  }
}

World sleeping(SceneDef scene) {
  freeze_all(scene);
  World world = made(scene);
  run(world, 5);
  return world;
}

SceneDef tower_of(std::uint32_t count) {
  SceneDef scene = tower(count);
  scene.world.method = sim::Method::kLayered;
  scene.world.dt = kDt;
  return scene;
}

sim::BoxDef static_cube(sim::BodyId id, const Vec3& at) {
  sim::BoxDef of = cube(id, at);
  of.is_static = true;
  return of;
}

using Flags = std::vector<std::uint8_t>;

TEST(WakingLayered, AStaticBoxPutIntoASleeperWakesItsIsland) {
  SceneDef scene = tower_of(3);
  scene.boxes.push_back(cube(4, {5, 0, 0.5}));
  World world = sleeping(scene);
  give(world, sim::Throw{static_cube(9, {0.9, 0, 1.5})});
  EXPECT_EQ(world.bodies().frozen, (Flags{0, 0, 0, 1, 0}));
  run(world, 2 * kSecond);
  EXPECT_LE(world.bodies().position[1].x(), -0.0985);
}

TEST(WakingLayered, AStaticBoxBesideASleeperWakesItWhereTheyTouch) {
  for (const double gap : {0.0, 0.0005, 0.002, 0.1}) {
    World world = sleeping(tower_of(2));
    give(world, sim::Throw{static_cube(9, {1 + gap, 0, 0.5})});
    const std::uint8_t asleep = gap > 0.001 ? 1 : 0;
    EXPECT_EQ(world.bodies().frozen, (Flags{asleep, asleep, 0})) << gap;
  }
}

// The load is laid on the end of a plank that sleeps on a static cube.
TEST(WakingLayered, ALoadLaidOnASleepingPlankTipsIt) {
  SceneDef scene = scene_of(8);
  scene.boxes = {static_cube(1, {0, 0, 0.5}), cube(2, {0, 0, 1.1})};
  scene.boxes[1].size = {4, 1, 0.2};
  World world = sleeping(scene);
  give(world, sim::Throw{cube(3, {1.5, 0, 1.7})});
  EXPECT_EQ(world.bodies().frozen[1], 0);
  run(world, 2 * kSecond);
  EXPECT_LT(world.bodies().position[2].z(), 1.2);
}

TEST(WakingLayered, WhatLayOnARemovedStaticBoxWakesAndFalls) {
  SceneDef scene = scene_of(8);
  scene.boxes = {static_cube(1, {0, 0, 0.5}), cube(2, {0, 0, 1.5}), cube(3, {0, 0, 2.5}), cube(4, {5, 0, 0.5})};
  World world = sleeping(scene);
  give(world, sim::Remove{1});
  EXPECT_EQ(world.bodies().frozen, (Flags{0, 0, 1}));
  run(world, 2 * kSecond);
  EXPECT_NEAR(world.bodies().position[1].z(), 1.5, 0.002);
}

// A body that is thrown in asleep lies there as if it had always done.
TEST(WakingLayered, ABoxThrownInAsleepWakesNothing) {
  World world = sleeping(tower_of(2));
  sim::BoxDef top = cube(9, {0, 0, 2.5});
  top.frozen = true;
  give(world, sim::Throw{top});
  EXPECT_EQ(world.bodies().frozen, (Flags{1, 1, 1}));
}

}  // namespace
}  // namespace tumble::test
