// Method layered where contacts lose what they carried, by an input: nothing that they remember may move a body.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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
constexpr sim::BodyId kPlate = 100;

SceneDef layered(SceneDef scene, bool freezing) {
  scene.world.method = sim::Method::kLayered;
  scene.world.dt = kDt;
  scene.world.substeps = 8;
  scene.world.freezing = freezing;
  return scene;
}

SceneDef tower_on_a_plate(std::uint32_t count, bool freezing) {
  SceneDef scene = tower(count);
  for (sim::BoxDef& box : scene.boxes) box.position.z() += 200;
  scene.boxes.push_back(cube(kPlate, {0, 0, 199.5}));
  scene.boxes.back().is_static = true;
  return layered(scene, freezing);
}

void advance_by(World& world, int steps) {
  for (int k = 0; k < steps; ++k) advance(world);
}

// m/s
double largest_speed(const World& world) {
  double most = 0;
  for (BodyIndex i = 0; i < world.bodies().size(); ++i) most = std::max(most, sim::length(world.bodies().velocity[i]));
  return most;
}

bool all_frozen(const World& world) {
  const sim::Bodies& bodies = world.bodies();
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    if (bodies.is_static[i] == 0 && bodies.frozen[i] == 0) return false;
  }
  return true;
}

class LostLoad : public testing::TestWithParam<bool> {};  // whether bodies may fall asleep

TEST_P(LostLoad, TowersStayWithoutGravity) {
  for (const std::uint32_t count : {4U, 10U, 60U}) {
    World world = made(layered(tower(count), GetParam()));
    advance_by(world, 60);
    ASSERT_EQ(all_frozen(world), GetParam());
    give(world, sim::SetGravity{Vec3::Zero()});
    advance_by(world, 30);
    EXPECT_LT(largest_speed(world), 1e-9) << count;  // up to 0.16 m/s, from impulses that carried the tower
  }
}

TEST_P(LostLoad, TowersStandOnWithAnotherDt) {
  World world = made(layered(tower(10), GetParam()));
  advance_by(world, 60);
  give(world, sim::SetDt{0.001});
  double most = 0;
  for (int k = 0; k < 30; ++k) {
    advance(world);
    most = std::max(most, largest_speed(world));
  }
  EXPECT_LT(most, 1e-6);  // 0.06 m/s
}

TEST_P(LostLoad, TowersFallAsOneWhenTheirSupportIsRemoved) {
  for (const std::uint32_t count : {2U, 10U, 40U}) {
    World world = made(tower_on_a_plate(count, GetParam()));
    advance_by(world, 60);
    ASSERT_EQ(all_frozen(world), GetParam());
    give(world, sim::Remove{kPlate});
    advance_by(world, 1);
    EXPECT_EQ(std::ranges::count(world.bodies().frozen, 1), 0) << "the island wakes as a whole";
    advance_by(world, 60);
    for (BodyIndex i = 0; i < world.bodies().size(); ++i) {
      EXPECT_NEAR(world.bodies().velocity[i].z(), -9.81 * kDt * 61, 1e-9) << count << ", row " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AwakeAndAsleep, LostLoad, testing::Bool());

// A removal is no reason to wake or to forget what hangs on nothing but the same static body.
TEST(LostLoads, AreThoseOfConnectedBodies) {
  SceneDef scene = on_ground();
  scene.boxes.push_back(cube(1, {0, 0, 0.5}));
  scene.boxes.back().is_static = true;
  scene.boxes.back().size = {20, 1, 1};
  for (const double x : {-5, 5}) {
    for (const double z : {1.5, 2.5}) scene.boxes.push_back(cube(scene.boxes.size() + 1, {x, 0, z}));
  }
  World world = made(layered(scene, true));
  advance_by(world, 60);
  ASSERT_TRUE(all_frozen(world));
  give(world, sim::Remove{2});
  EXPECT_EQ(world.bodies().frozen, (std::vector<std::uint8_t>{0, 0, 1, 1}));
}

TEST(Sleep, NeedsSomethingThatHolds) {
  SceneDef scene = on_ground();
  scene.boxes.push_back(cube(1, {0, 0, 10}));
  scene.boxes.push_back(cube(2, {1, 0, 10}));
  for (sim::BoxDef& box : scene.boxes) box.velocity = {0.05, 0, 0};
  for (const double pull : {0.0, -1e-3}) {
    scene.world.gravity = {0, 0, pull};
    World world = made(layered(scene, true));
    advance_by(world, 180);
    for (BodyIndex i = 0; i < 2; ++i) {
      EXPECT_EQ(world.bodies().frozen[i], 0);
      EXPECT_NEAR(world.bodies().velocity[i].x(), 0.05, 1e-9) << "they touch, are slow, and drift on";
    }
  }
}

// What slides over the ground without gravity is not held by it.
TEST(Sleep, NeedsGravity) {
  SceneDef scene = on_ground();
  scene.boxes.push_back(cube(1, {0, 0, 0.5}));
  scene.boxes.back().velocity = {0.05, 0, 0};
  scene.world.gravity = Vec3::Zero();
  World world = made(layered(scene, true));
  advance_by(world, 180);
  EXPECT_NEAR(world.bodies().velocity[0].x(), 0.05, 1e-9);
}

}  // namespace
}  // namespace tumble::test
