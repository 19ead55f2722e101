// Method layered as a whole: exact like the other, and stacks that stand.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "src/world/scratch.h"
#include "tests/support/sim_scenes.h"
#include "tests/support/transforms.h"

namespace tumble::test {
namespace {

using sim::SceneDef;
using sim::Vec3;
using sim::World;

SceneDef layered(SceneDef scene, std::uint64_t steps, double dt = 1.0 / 60, std::uint32_t substeps = 8) {
  scene.world.method = sim::Method::kLayered;
  scene.world.dt = dt;
  scene.world.substeps = substeps;
  scene.steps = steps;
  return scene;
}

World run(const SceneDef& scene) {
  World world = made(scene);
  while (world.state().step < scene.steps) advance(world);
  return world;
}

// The step after which a scene and its image differ, 0 for never.
std::uint64_t first_difference(const SceneDef& given, const Transform& transform) {
  const SceneDef scene = resolved(given);
  const IdMap names = ids_under(scene, transform);
  World original = made(scene), image = made(image_of(scene, transform, names));
  while (original.state().step < scene.steps) {
    advance(original);
    advance(image);
    if (differing_bodies(original, image, transform, names) > 0) return original.state().step;
  }
  return 0;
}

void expect_images_alike(const SceneDef& scene) {
  for (const Transform& transform : all_transforms())
    EXPECT_EQ(first_difference(scene, transform), 0) << to_string(transform);
}

double drift(const World& world, const SceneDef& scene) {
  double most = 0;
  for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
    const Vec3 way = world.bodies().position[i] - scene.boxes[i].position;
    most = std::max(most, std::sqrt(way.x() * way.x() + way.y() * way.y()));
  }
  return most;
}

TEST(LayeredExactness, JitteredPile) {
  SceneDef scene = pile(5);
  jitter(scene, 0.05, 3);
  expect_images_alike(layered(scene, 150));
}

TEST(LayeredExactness, Tumble) { expect_images_alike(layered(tumble_of_boxes(5, 11), 150)); }

TEST(LayeredExactness, FrozenWallHitByACube) {
  SceneDef scene = wall(6, 6);
  freeze_all(scene);
  add_thrown_cube(scene);
  expect_images_alike(layered(scene, 150));
}

TEST(LayeredExactness, RampPlatesAndBars) {
  expect_images_alike(layered(ramp(12, 5), 150));
  expect_images_alike(layered(plates_and_bars(20, 5), 150));
}

TEST(LayeredExactness, AThousandToOne) {
  SceneDef scene = pyramid(4);
  jitter(scene, 0.02, 9);
  Random random(9);
  for (sim::BoxDef& box : scene.boxes) box.mass = std::pow(10, random.uniform(0, 3));
  expect_images_alike(layered(scene, 60));
}

TEST(LayeredExactness, AnyGravity) {
  SceneDef scene = pyramid(4);
  jitter(scene, 0.02, 6);
  for (const Vec3& gravity : {Vec3(-1.5, -0.7, -9.81), Vec3(9, 3, 0), Vec3(0, 0, 9.81), Vec3(0, 0, 0)}) {
    scene.world.gravity = gravity;
    expect_images_alike(layered(scene, 30));
  }
}

TEST(LayeredExactness, TiltedGridStaysInItsColumns) {
  for (const auto& [dt, substeps] : {std::pair{1.0 / 30, 4U}, std::pair{1.0 / 300, 1U}}) {
    const std::uint32_t n = 10;
    const SceneDef scene =
        resolved(layered(tilted_grid(n), static_cast<std::uint64_t>(std::lround(5 / dt)), dt, substeps));
    const World world = run(scene);
    const sim::Bodies& bodies = world.bodies();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      EXPECT_EQ(bodies.position.x[i], scene.boxes[i].position.x());
      EXPECT_EQ(bodies.position.y[i], bodies.position.y[i - i % n]);
      EXPECT_EQ(bodies.position.z[i], bodies.position.z[i - i % n]);
    }
  }
}

TEST(LayeredExactness, GoesOnFromEveryStep) {
  SceneDef scene = pile(3);
  jitter(scene, 0.05, 3);
  scene = layered(scene, 90);
  World world = made(scene);
  const Hash128 end = sim::continuation_hash(run(scene).state());
  while (world.state().step < scene.steps) {
    auto other = World::restore(world.state());
    ASSERT_TRUE(other.ok()) << other.error().message;
    while (other->state().step < scene.steps) advance(*other);
    ASSERT_EQ(sim::continuation_hash(other->state()), end) << "from step " << world.state().step;
    advance(world);
  }
}

void advance_with_inputs(World& world) {
  const std::uint64_t done = world.state().step;
  if (done == 15) give(world, sim::SetDt{1.0 / 45});
  if (done == 30) give(world, sim::SetGravity{{1, 0, -9}});
  if (done == 45) give(world, sim::Remove{2});
  if (done == 60) give(world, sim::SetGravity{{0, 0, -9.81}});
  if (done == 75) give(world, sim::Wake{5});
  advance(world);
}

// Sleepers, lent inertia and every kind of change in between: nothing of it may hide outside the state.
TEST(LayeredExactness, GoesOnFromEveryStepThroughInputs) {
  SceneDef scene = pyramid(4);
  jitter(scene, 0.02, 4);
  scene.boxes[8].mass = 500;
  scene.boxes[9].mass = 3000;
  add_thrown_cube(scene);
  World through = made(layered(scene, 90, 1.0 / 60, 4));
  std::vector<sim::WorldState> states;
  while (through.state().step < 90) {
    states.push_back(through.state());
    advance_with_inputs(through);
  }
  const Hash128 end = sim::continuation_hash(through.state());
  for (const sim::WorldState& state : states) {
    auto other = World::restore(state);
    ASSERT_TRUE(other.ok()) << other.error().message;
    while (other->state().step < 90) advance_with_inputs(*other);
    ASSERT_EQ(sim::continuation_hash(other->state()), end) << "from step " << state.step;
  }
}

TEST(LayeredStacks, JitteredTowerStandsWithoutFreezing) {
  SceneDef scene = tower(20);
  jitter(scene, 0.01, 20);
  scene = layered(scene, 600);
  scene.world.freezing = false;
  const World world = run(scene);
  EXPECT_LT(drift(world, scene), 0.002);
  EXPECT_GT(world.bodies().position.z.back(), 19.495);
}

TEST(LayeredStacks, JitteredPyramidComesToRest) {
  SceneDef scene = pyramid(12);
  jitter(scene, 0.01, 4);
  const World world = run(layered(scene, 300));
  EXPECT_LT(drift(world, scene), 0.003);
  for (const std::uint8_t frozen : world.bodies().frozen) EXPECT_EQ(frozen, 1);
}

// v² = 2 g h keeps its value at restitution 1; a plain symplectic step loses half of it in ten bounces.
TEST(LayeredBounce, KeepsItsHeight) {
  SceneDef scene = on_ground();
  scene.boxes = {cube(1, {0, 0, 2.5})};
  scene.boxes[0].material.restitution = 1;
  scene.world.ground_material.restitution = 1;
  scene = layered(scene, 6000, 1.0 / 300);
  World world = made(scene);
  int tops = 0;
  for (double before = 0; tops < 10 && world.state().step < scene.steps;) {
    advance(world);
    const double now = world.bodies().velocity.z[0];
    if (before > 0 && now <= 0) {
      ++tops;
      EXPECT_NEAR(world.bodies().position.z[0] - 0.5, 2, 0.02) << "bounce " << tops;
    }
    before = now;
  }
  EXPECT_EQ(tops, 10);
}

// A wall that sleeps must give way to what hits it, as a whole and at once, not throw it back like the ground.
TEST(LayeredSleep, AHitWakesTheWholeIsland) {
  SceneDef scene = tower(3);
  freeze_all(scene);
  scene.boxes.push_back(cube(4, {0, -1.6, 1.5}));
  scene.boxes.back().velocity = {0, 6, 0};
  World world = made(layered(scene, 1));
  while (world.bodies().position.y[3] < -1.1) advance(world);
  advance(world);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(world.bodies().frozen[static_cast<std::size_t>(i)], 0) << i;
  EXPECT_GT(world.bodies().velocity.y[1], 1) << "half of the speed, less friction";
}

TEST(LayeredSleep, RemovingASupportWakesWhatItCarried) {
  SceneDef scene = tower(3);
  freeze_all(scene);
  World world = made(layered(scene, 1));
  advance(world);
  give(world, sim::Remove{1});
  for (int k = 0; k < 60; ++k) advance(world);
  EXPECT_LT(world.bodies().position.z[0], 0.52);
  EXPECT_LT(world.bodies().position.z[1], 1.52);
}

// 0.1 m at 100 m/s and 1/60 s is seventeen of its own lengths a step; the plate is half as thick as the box.
// One step, beside that of a world which knows nothing of the steps before.
void expect_same_as_fresh(World& world) {
  Result<World> fresh = World::restore(world.state());
  ASSERT_TRUE(fresh.ok());
  sim::PhaseHashes hashes, fresh_hashes;
  const auto counters = sim::step(world, &hashes);
  auto expected = sim::step(*fresh, &fresh_hashes);
  ASSERT_TRUE(counters.ok() && expected.ok());
  expected->inputs = counters->inputs;  // which came before
  ASSERT_EQ(hashes.words(), fresh_hashes.words()) << "step " << world.state().step;
  ASSERT_EQ(*counters, *expected) << "step " << world.state().step;
  ASSERT_EQ(sim::continuation_hash(world.state()), sim::continuation_hash(fresh->state()));
}

TEST(LayeredSleep, AStillWorldIsSteppedAsIfItWereNot) {
  SceneDef scene = tower(4);
  scene.boxes.insert(scene.boxes.end(), {cube(5, {5, 0, 0.5}), cube(6, {9, 0, 0.5})});
  World world = made(layered(scene, 1));
  for (int k = 0; k < 200 && world.scratch().still_steps < 6; ++k) expect_same_as_fresh(world);
  ASSERT_EQ(world.scratch().still_steps, 6U) << "everything should sleep";
  give(world, sim::Remove{5});  // wakes nobody
  for (int k = 0; k < 6; ++k) expect_same_as_fresh(world);
  EXPECT_EQ(world.scratch().still_steps, 6U);
  give(world, sim::Remove{1});
  for (int k = 0; k < 6; ++k) expect_same_as_fresh(world);
  EXPECT_EQ(world.scratch().still_steps, 0U) << "what stood on the lowest falls";
}

TEST(LayeredFast, AFastSmallBoxDoesNotTunnel) {
  SceneDef scene = empty_space();
  scene.boxes = {cube(1, {0, 0, 0}), cube(2, {-5, 0.1, 0.3})};
  scene.boxes[0].size = {0.05, 4, 4};
  scene.boxes[0].is_static = true;
  scene.boxes[1].size = {0.1, 0.1, 0.1};
  scene.boxes[1].velocity = {100, 0, 0};
  const World world = run(layered(scene, 30));
  EXPECT_LT(world.bodies().position.x[1], -0.05);
}

}  // namespace
}  // namespace tumble::test
