// Thesis III.D: three criteria, two thresholds, contact objects. Each criterion fails on its own below.
#include <cmath>

#include "tests/sim/freezing_scenes.h"

namespace tumble::test {
namespace {

// ½ v² < 0.0032 J/kg: v < 0.08 m/s. A cube's ½ w² I/m is w²/12: w < √0.0384 = 0.19596 rad/s. Both together: their sum.
TEST(Freezing, NeedsEnergyBelowTheThreshold) {
  World slow = one_cube({0.0799, 0, 0}, {0, 0, 0}), fast = one_cube({0.0801, 0, 0}, {0, 0, 0});
  EXPECT_TRUE(is_frozen_after(slow, 4, {kOnGround}));
  EXPECT_FALSE(is_frozen_after(fast, 40, {kOnGround}));
  World turning_slow = one_cube({0, 0, 0}, {0, 0.1959, 0}), turning_fast = one_cube({0, 0, 0}, {0, 0.1961, 0});
  EXPECT_TRUE(is_frozen_after(turning_slow, 4, {kOnGround}));
  EXPECT_FALSE(is_frozen_after(turning_fast, 40, {kOnGround}));
  World both = one_cube({0, 0.06, 0}, {0, 0.15, 0});  // 0.0018 + 0.001875
  EXPECT_FALSE(is_frozen_after(both, 40, {kOnGround}));
}

TEST(Freezing, NeedsTheEnergyToStayLowForFreezeTime) {
  World world = one_cube({0.01, 0, 0}, {0, 0, 0});
  EXPECT_FALSE(is_frozen_after(world, 3, {kOnGround}));
  EXPECT_EQ(world.bodies().low_energy_time[0], 0.375);
  EXPECT_TRUE(is_frozen_after(world, 1, {kOnGround})) << "½ s is enough";
}

TEST(Freezing, AnInterruptionStartsTheTimeAnew) {
  World world = one_cube({0.01, 0, 0}, {0, 0, 0});
  EXPECT_FALSE(is_frozen_after(world, 3, {kOnGround}));
  world.mutable_state().bodies.velocity.set(0, {1, 0, 0});
  EXPECT_FALSE(is_frozen_after(world, 1, {kOnGround}));
  world.mutable_state().bodies.velocity.set(0, {0.01, 0, 0});
  EXPECT_FALSE(is_frozen_after(world, 3, {kOnGround}));
  EXPECT_TRUE(is_frozen_after(world, 1, {kOnGround}));
}

TEST(Freezing, NeedsACollisionInThatStep) {
  World world = one_cube({0.01, 0, 0}, {0, 0, 0});
  EXPECT_FALSE(is_frozen_after(world, 20, {}));
  EXPECT_TRUE(is_frozen_after(world, 1, {kOnGround}));
}

// "When an object becomes frozen, its velocities (linear and angular) are set to zero."
TEST(Freezing, StopsTheBody) {
  World world = one_cube({0.01, 0.02, -0.03}, {0.01, 0.02, 0.03});
  ASSERT_TRUE(is_frozen_after(world, 4, {kOnGround}));
  EXPECT_EQ(world.bodies().velocity[0], Vec3(0, 0, 0));
  EXPECT_EQ(world.bodies().spin[0], Vec3(0, 0, 0));
  const Vec3 position = world.bodies().position[0];
  advance(world);
  EXPECT_EQ(world.bodies().position[0], position) << "a frozen body is not moved by the step";
}

TEST(Freezing, CanBeSwitchedOff) {
  World world = one_cube({0, 0, 0}, {0, 0, 0});
  world.mutable_state().def.freezing = false;
  EXPECT_FALSE(is_frozen_after(world, 40, {kOnGround}));
}

// The escape threshold is twice the entering one: ½ v² > 0.0064, v > 0.113137.
TEST(Escape, NeedsTwiceTheFreezingEnergy) {
  for (const double speed : {0.1131, 0.1132}) {
    SceneDef scene = cubes_at({{0, 0, 0.5}});
    scene.boxes[0].frozen = true;
    World world = made(scene);
    const Vec3 velocity(0, speed, 0);
    world.mutable_state().bodies.velocity.set(0, velocity);  // what an impulse would have given
    update(world, {kOnGround});
    const bool escapes = speed > 0.1131371;
    EXPECT_EQ(world.bodies().frozen[0] == 0, escapes) << speed;
    EXPECT_EQ(world.bodies().velocity[0], escapes ? velocity : Vec3(0, 0, 0));
    EXPECT_EQ(world.state().contact_objects.size(), escapes ? 0U : 1U);
  }
}

// A thrown cube of 1 kg meets a frozen one of 1 kg head-on, ε = 0: both have v/2 after it, if the frozen one escapes,
// which it does for v/2 > 0.1131. A body hit too softly stands as if nailed, and hitting it is not free: v/2 is kept.
TEST(Escape, FollowsFromARealCollision) {
  for (const double speed : {0.22, 0.23}) {
    SceneDef scene = empty_space();
    scene.boxes = {cube(1, {0, 0, 0}), cube(2, {1.001, 0, 0})};
    scene.boxes[0].frozen = true;
    scene.boxes[1].velocity = {-speed, 0, 0};
    for (BoxDef& b : scene.boxes) b.material = {0, 0, 0};
    World world = made(scene);
    advance(world);
    EXPECT_EQ(world.bodies().frozen[0], speed < 0.2263 ? 1 : 0);
    EXPECT_NEAR(world.bodies().velocity.x[0], speed < 0.2263 ? 0 : -speed / 2, 1e-11);
    EXPECT_NEAR(world.bodies().velocity.x[1], -speed / 2, 1e-11);
  }
}

World candidate_with(const std::vector<Vec3>& others, const std::vector<Touch>& touches) {
  std::vector<Vec3> positions = {{0, 0, 5}};
  positions.insert(positions.end(), others.begin(), others.end());
  SceneDef scene = cubes_at(positions);
  for (std::size_t k = 1; k < scene.boxes.size(); ++k) scene.boxes[k].frozen = true;
  World world = made(scene);
  for (int k = 0; k < 4; ++k) update(world, touches);
  return world;
}

// "If the object A has multiple collisions, the colliding object that has the lowest z position is the CO."
TEST(ContactObject, IsTheLowestBodyTouched) {
  for (const bool lowest_first : {true, false}) {
    const double first = lowest_first ? 4.0 : 4.1, second = lowest_first ? 4.1 : 4.0;
    const World world =
        candidate_with({{0.5, 0, first}, {-0.5, 0, second}, {0, 0, 6}}, {{0, 1, kDown}, {0, 2, kDown}, {0, 3, kUp}});
    EXPECT_EQ(world.bodies().frozen[0], 1);
    EXPECT_EQ(objects_of(world, 0), (std::vector<BodyIndex>{lowest_first ? 1U : 2U}));
  }
}

TEST(ContactObject, IsTheSetOfThemOnATie) {
  const World world =
      candidate_with({{0.5, 0, 4}, {-0.5, 0, 4.5}, {-0.5, 0, 4}}, {{0, 1, kDown}, {0, 2, kDown}, {0, 3, kDown}});
  EXPECT_EQ(objects_of(world, 0), (std::vector<BodyIndex>{1, 3}));
}

TEST(ContactObject, GroundIsLowerThanAnything) {
  const World world = candidate_with({{0.5, 0, -100}}, {{0, 1, kDown}, kOnGround});
  EXPECT_EQ(objects_of(world, 0), (std::vector<BodyIndex>{kGround}));
}

// "If object B has a lower z position than object A, B is the CO": one that only hangs beside or above carries nothing.
TEST(ContactObject, BodiesBesideAndAboveCarryNothing) {
  for (const double height : {5.0, 6.0}) {
    const World world = candidate_with({{1, 0, height}}, {{0, 1, {1, 0, 0}}});
    EXPECT_EQ(world.bodies().frozen[0], 0) << height;
  }
}

// Rests only on what rests: the lower body must be frozen itself.
TEST(ContactObject, MustBeAtRestItself) {
  World world = candidate_with({{0, 0, 4}}, {{0, 1, kDown}});
  EXPECT_EQ(world.bodies().frozen[0], 1);
  SceneDef scene = cubes_at({{0, 0, 5}, {0, 0, 4}});
  World moving = made(scene);
  moving.mutable_state().bodies.velocity.set(1, {1, 0, 0});
  for (int k = 0; k < 20; ++k) {
    update(moving, {{0, 1, kDown}});
    EXPECT_EQ(moving.bodies().frozen[0], 0) << "update " << k;
  }
}

// A static ramp carries what it presses from below, however high its centre; a static ceiling does not.
TEST(ContactObject, StaticRampCarriesWhateverItsCentre) {
  for (const bool from_below : {true, false}) {
    SceneDef scene = cubes_at({{0, 0, 5}, {9, 0, 7}});
    scene.boxes[1].is_static = true;
    World world = made(scene);
    const Vec3 down_the_slope(0.6, 0, from_below ? -0.8 : 0.8);
    for (int k = 0; k < 4; ++k) update(world, {{0, 1, down_the_slope}});
    EXPECT_EQ(world.bodies().frozen[0], from_below ? 1 : 0);
  }
}

// Low is along gravity: pulled towards +x, the body at larger x carries.
TEST(ContactObject, LowIsAlongGravity) {
  SceneDef scene = cubes_at({{0, 0, 5}, {1, 0, 5}, {-1, 0, 4}});
  scene.world.gravity = {9.81, 0, 0};
  scene.boxes[1].frozen = scene.boxes[2].frozen = true;
  World world = made(scene);
  for (int k = 0; k < 4; ++k) update(world, {{0, 1, {1, 0, 0}}, {0, 2, {-1, 0, 0}}});
  EXPECT_EQ(objects_of(world, 0), (std::vector<BodyIndex>{1}));
}

TEST(ContactObject, WithoutGravityNothingFreezes) {
  SceneDef scene = cubes_at({{0, 0, 5}, {0, 0, 4}});
  scene.world.gravity = {0, 0, 0};
  scene.boxes[1].frozen = true;
  World world = made(scene);
  for (int k = 0; k < 20; ++k) update(world, {{0, 1, kDown}, kOnGround});
  EXPECT_EQ(world.bodies().frozen[0], 0);
}

// End to end: a dropped cube comes to rest on the ground, freezes ½ s later at the earliest, and stays.
TEST(Freezing, DroppedCubeComesToRestAndFreezes) {
  SceneDef scene = cubes_at({{0, 0, 0.8}});
  scene.world.substeps = 8;
  World world = made(scene);
  int first = 0;
  for (int step = 1; step <= 300; ++step) {
    advance(world);
    if (first == 0 && world.bodies().frozen[0] != 0) first = step;
  }
  EXPECT_GT(first, 30);
  EXPECT_LT(first, 150);
  EXPECT_EQ(world.bodies().frozen[0], 1);
  EXPECT_NEAR(world.bodies().position.z[0], 0.5, 0.005);
  EXPECT_EQ(objects_of(world, 0), (std::vector<BodyIndex>{kGround}));
}

}  // namespace
}  // namespace tumble::test
