// Bars: contacts that are hard to solve, and a body that turns thousands of times as easily one way as another.
#include <gtest/gtest.h>

#include <algorithm>

#include "src/world/scratch.h"
#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::SceneDef;
using sim::SweepGroup;
using sim::Vec3;
using sim::World;

SceneDef layered(SceneDef scene) {
  scene.world.method = sim::Method::kLayered;
  scene.world.dt = 1.0 / 60;
  scene.world.substeps = 8;
  return scene;
}

// Two bars crosswise at the origin, a cube on them if wanted, and a tower of three cubes far away.
SceneDef bars_and_tower(bool cube_on_bars) {
  SceneDef scene = layered(on_ground());
  const auto put = [&](const Vec3& size, const Vec3& at) {
    scene.boxes.push_back(box(scene.boxes.size() + 1, size, at));
  };
  put({4, 0.1, 0.1}, {0, 0, 0.05});
  put({0.1, 4, 0.1}, {0, 0, 0.15});
  if (cube_on_bars) put({1, 1, 1}, {0, 0, 0.7});
  for (int k = 0; k < 3; ++k) put({1, 1, 1}, {20, 0, 0.5 + k});
  return scene;
}

// How many manifolds a group has.
std::size_t members(const World& world, const SweepGroup& group) {
  return world.scratch().layer_start[group.end] - world.scratch().layer_start[group.begin];
}

TEST(Slender, IslandsWithABarAreSweptMoreOftenAndNoOthers) {
  World world = made(bars_and_tower(false));
  advance(world);
  const std::vector<SweepGroup>& groups = world.scratch().sweep_groups;
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(world.scratch().islands.sweeps.back(), 1);
  EXPECT_GE(groups[1].sweeps, 20);
  EXPECT_FALSE(groups[0].hard);
  EXPECT_TRUE(groups[1].hard);
  EXPECT_EQ(groups[0].end, groups[1].begin);
  EXPECT_GE(members(world, groups[0]), 3U) << "the tower";
  EXPECT_GE(members(world, groups[1]), 2U) << "the bars";
}

TEST(Slender, ACubeOnABarIsOfItsIsland) {
  World without = made(bars_and_tower(false)), with = made(bars_and_tower(true));
  advance(without);
  advance(with);
  EXPECT_EQ(members(with, with.scratch().sweep_groups[0]), members(without, without.scratch().sweep_groups[0]));
  EXPECT_GT(members(with, with.scratch().sweep_groups[1]), members(without, without.scratch().sweep_groups[1]));
}

TEST(Slender, NobodyElseHasSuchAGroup) {
  World world = made(layered(pile(3)));
  for (int k = 0; k < 30; ++k) advance(world);
  ASSERT_EQ(world.scratch().sweep_groups.size(), 1U);
  EXPECT_FALSE(world.scratch().sweep_groups[0].hard);
}

// Without friction nothing calms a solver that overshoots: responses that were not fitted to bars that had turned let
// this cabin fly apart at once.
TEST(Slender, ACabinFallsDownWithoutFrictionAndGainsNothing) {
  SceneDef scene = layered(on_ground());
  for (int layer = 0; layer < 20; ++layer) {
    for (const double side : {-2.5, 2.5}) {
      const bool along_x = layer % 2 == 0;
      const double z = 0.05 + 0.1 * layer;
      scene.boxes.push_back(box(scene.boxes.size() + 1, along_x ? Vec3(6, 0.1, 0.1) : Vec3(0.1, 6, 0.1),
                                along_x ? Vec3(0.01 * layer, side, z) : Vec3(side, 0.02 * layer, z)));
    }
  }
  scene.boxes.push_back(box(100, {0.75, 0.75, 0.75}, {-2, -1, 3.5}));
  scene.boxes.back().velocity = {6, 1, -6};
  for (sim::BoxDef& one : scene.boxes) one.material.friction = one.material.friction_dynamic = 0;
  World world = made(scene);
  const double start = total_energy(world.state()).kinetic + total_energy(world.state()).potential;
  double least = start, gain = 0;
  for (int k = 0; k < 300; ++k) {
    advance(world);
    const sim::Energy now = total_energy(world.state());
    least = std::min(least, now.kinetic + now.potential);
    gain = std::max(gain, now.kinetic + now.potential - least);
  }
  EXPECT_LT(gain, 0.02 * start);
}

}  // namespace
}  // namespace tumble::test
