// What phases do to each body by itself: the same bits in lanes as for one body after the other.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "src/collide/find_near_pairs.h"
#include "src/solve/integrate.h"
#include "src/step/step.h"
#include "src/world/body_check.h"
#include "src/world/body_kernels.h"
#include "tests/support/sim_scenes.h"

namespace tumble::sim {
namespace {

constexpr std::array<LaneWidth, 3> kWidths = {LaneWidth::kTwo, LaneWidth::kFour, LaneWidth::kEight};
constexpr double kDt = 1.0 / 60;

// Bodies of every kind in no order: cubes and uneven boxes, frozen and static ones; 43 of them fill no vector evenly.
SceneDef mixed_bodies(std::uint64_t seed) {
  test::Random random(seed);
  SceneDef scene = test::on_ground();
  scene.world.method = Method::kLayered;
  scene.world.air_drag = seed % 2 == 0 ? 0 : 0.3;
  for (BodyId id = 1; id <= 43; ++id) {
    const auto number = [&](double most) { return random.uniform(-most, most); };
    const double size = random.uniform(0.2, 2);
    const bool even = random.uniform(0, 1) < 0.8;
    BoxDef box =
        test::box(id, even ? Vec3(size, size, size) : Vec3(size, 2 * size, 0.5), {number(9), number(9), number(9)});
    box.orientation = random.rotation();
    box.velocity = {number(20), number(20), number(20)};
    box.spin = {number(5), number(5), number(5)};
    box.is_static = random.uniform(0, 1) < 0.1;
    scene.boxes.push_back(box);
  }
  return scene;
}

World world_in(const SceneDef& scene, LaneWidth width) {
  World world = *World::create(scene);
  world.mutable_scratch().lanes = width;
  Bodies& bodies = world.mutable_state().bodies;
  for (BodyIndex i = 0; i < bodies.size(); i += 5) bodies.frozen[i] = bodies.is_static[i] == 0 ? 1 : 0;
  return world;
}

TEST(BodyLanes, FlyAsOneBodyDoes) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const SceneDef scene = mixed_bodies(seed);
    World one = world_in(scene, LaneWidth::kOne);
    const Bodies before = one.bodies();
    ASSERT_TRUE(integrate(one, kDt).ok());
    ASSERT_NE(one.bodies().position.z, before.position.z);
    for (const LaneWidth width : kWidths) {
      if (body_kernels(width) == nullptr) continue;
      World other = world_in(scene, width);
      ASSERT_TRUE(integrate(other, kDt).ok());
      ASSERT_EQ(state_hash(one.bodies()), state_hash(other.bodies())) << name_of(width) << " lanes, seed " << seed;
    }
  }
}

TEST(BodyLanes, AreFramedAndReachOutAsOneBodyDoes) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const SceneDef scene = mixed_bodies(seed);
    World one = world_in(scene, LaneWidth::kOne);
    ASSERT_TRUE(find_near_pairs(one, kDt).ok());
    Hasher expected;
    hash_find_near_pairs(one, expected);
    for (const LaneWidth width : kWidths) {
      if (body_kernels(width) == nullptr) continue;
      World other = world_in(scene, width);
      ASSERT_TRUE(find_near_pairs(other, kDt).ok());
      Hasher found;
      hash_find_near_pairs(other, found);
      ASSERT_EQ(expected.digest(), found.digest()) << name_of(width) << " lanes, seed " << seed;
      ASSERT_EQ(one.scratch().aabb_low, other.scratch().aabb_low) << name_of(width) << " lanes, seed " << seed;
      ASSERT_EQ(one.scratch().aabb_high, other.scratch().aabb_high) << name_of(width) << " lanes, seed " << seed;
    }
  }
}

TEST(BodyLanes, NameTheFirstBodyThatIsWrong) {
  const SceneDef scene = mixed_bodies(2);
  const auto break_number = [](Bodies& bodies, BodyIndex i, int what) {
    if (what == 0) bodies.position.y[i] = -32769;
    if (what == 1) bodies.velocity.z[i] = std::nan("");
    if (what == 2) bodies.spin.x[i] = HUGE_VAL;
    if (what == 3) bodies.orientation.w[i] += 0.001;
  };
  for (BodyIndex i = 0; i < scene.boxes.size(); ++i) {
    World one = world_in(scene, LaneWidth::kOne);
    break_number(one.mutable_state().bodies, i, static_cast<int>(i % 4));
    const Status expected = check_moving(one);
    ASSERT_EQ(expected.ok(), !one.bodies().moves(i));
    for (const LaneWidth width : kWidths) {
      if (body_kernels(width) == nullptr) continue;
      World other = world_in(scene, width);
      break_number(other.mutable_state().bodies, i, static_cast<int>(i % 4));
      const Status found = check_moving(other);
      ASSERT_EQ(expected.ok(), found.ok()) << name_of(width) << " lanes, row " << i;
      if (found.ok()) continue;
      ASSERT_EQ(expected.error().message, found.error().message) << name_of(width);
    }
  }
}

}  // namespace
}  // namespace tumble::sim
