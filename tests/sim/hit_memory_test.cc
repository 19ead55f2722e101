// Method layered after a hit: what stopped a body must not move it again.
#include <gtest/gtest.h>

#include <utility>

#include "tests/support/sim_scenes.h"
#include "tumble/sim/world_state.h"

namespace tumble::test {
namespace {

using sim::BodyIndex;
using sim::SceneDef;
using sim::Vec3;
using sim::World;

constexpr sim::Material kRough{.friction = 0.848, .friction_dynamic = 0.304, .restitution = 0},
    kIce{.friction = 0, .friction_dynamic = 0, .restitution = 0};

SceneDef layered(double dt, std::uint32_t substeps, const sim::Material& ground) {
  SceneDef scene = on_ground();
  scene.world.method = sim::Method::kLayered;
  scene.world.dt = dt;
  scene.world.substeps = substeps;
  scene.world.freezing = false;
  scene.world.ground_material = ground;
  return scene;
}

void add(SceneDef& scene, const Vec3& size, const Vec3& position, const Vec3& velocity, const sim::Material& material) {
  scene.boxes.push_back(box(static_cast<sim::BodyId>(scene.boxes.size() + 1), size, position));
  scene.boxes.back().velocity = velocity;
  scene.boxes.back().material = material;
}

// The second step stops the box some millimetres above a plate that has rested for a step; it does not reach the plate
// in the third.
TEST(AfterAHit, ABoxThatMeetsNothingFallsOnAlone) {
  SceneDef scene = layered(0.02, 4, kRough);
  add(scene, {0.6, 0.6, 0.58}, {0, 0, 0.904038}, {2, 0, -2.4038}, kRough);
  add(scene, {6, 6, 0.5}, {0, 0, 0.25}, {0, 0, 0}, kRough);
  scene.boxes[1].mass = 1e6;
  World world = made(scene);
  advance(world);
  advance(world);
  const Vec3 before = world.bodies().velocity[0];
  ASSERT_GT(before.z(), -0.1) << "stopped";
  ASSERT_GT(world.bodies().position[0].z(), 0.5 + 0.29 + 0.002) << "above the plate";
  advance(world);
  const Vec3 after = world.bodies().velocity[0];
  EXPECT_NEAR(after.x(), before.x(), 1e-9);
  EXPECT_NEAR(after.y(), before.y(), 1e-9);
  EXPECT_NEAR(after.z(), before.z() + scene.world.gravity.z() * scene.world.dt, 1e-9);
}

// Bodies that float stay together after a hit without restitution: no substep begins with what stopped the hit before.
// Two substeps sweep too little to pass a hit on through six bodies.
TEST(AfterAHit, ARowMovesAsOne) {
  for (const auto& [substeps, apart] : {std::pair{2U, 0.13}, {4U, 0.02}, {8U, 0.001}, {16U, 0.001}}) {
    SceneDef scene = layered(1.0 / 60, substeps, kIce);
    scene.world.gravity = Vec3::Zero();
    for (int k = 0; k < 5; ++k) add(scene, {1, 1, 1}, {static_cast<double>(k), 0, 10}, Vec3::Zero(), kIce);
    add(scene, {1, 1, 1}, {-2, 0, 10}, {10, 0, 0}, kIce);
    World world = made(scene);
    for (int k = 0; k < 20; ++k) advance(world);
    for (BodyIndex i = 0; i < 6; ++i) {
      EXPECT_NEAR(world.bodies().velocity.x[i], 10.0 / 6, apart) << substeps << " substeps, body " << i;
    }
  }
}

TEST(AfterAHit, NoBoxIsThrownUp) {
  for (const std::uint32_t substeps : {1U, 2U, 8U}) {
    SceneDef scene = layered(0.03, substeps, kIce);
    add(scene, {1, 1.3, 1.005}, {0, 0, 0.503}, {0, 0, 0}, kIce);
    add(scene, {1, 1.3, 1.01}, {0, 0, 1.57}, {0, 0, -2.5}, kIce);
    World world = made(scene);
    for (int k = 0; k < 20; ++k) {
      advance(world);
      if (k < 2) continue;  // the steps of the hit
      for (BodyIndex i = 0; i < world.bodies().size(); ++i) {
        EXPECT_LE(world.bodies().velocity[i].z(), 0.01) << substeps << " substeps, step " << k << ", box " << i + 1;
      }
    }
  }
}

}  // namespace
}  // namespace tumble::test
