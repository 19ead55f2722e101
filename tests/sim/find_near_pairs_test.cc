// The broad phase of method layered: strips, and cells where boxes crowd, against looking at every pair.
#include "src/layered/find/find_near_pairs.h"

#include <gtest/gtest.h>

#include <tuple>
#include <utility>
#include <vector>

#include "src/world/scratch.h"
#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::BodyIndex;
using sim::SceneDef;
using sim::Vec3;
using sim::World;
using Pairs = std::vector<std::pair<BodyIndex, BodyIndex>>;

Pairs all_overlaps(const sim::Scratch& scratch) {
  Pairs pairs;
  const std::size_t n = scratch.frames.size();
  for (BodyIndex a = 0; a < n; ++a) {
    for (BodyIndex b = a + 1; b < n; ++b) {
      const Vec3 low_a = scratch.aabb_low[a], low_b = scratch.aabb_low[b];
      const Vec3 high_a = scratch.aabb_high[a], high_b = scratch.aabb_high[b];
      if ((low_a.array() <= high_b.array()).all() && (low_b.array() <= high_a.array()).all()) pairs.emplace_back(a, b);
    }
  }
  return pairs;
}

void expect_all_found(SceneDef scene) {
  scene.world.method = sim::Method::kLayered;
  World world = made(scene);
  ASSERT_TRUE(test::run_phase(sim::find_near_pairs, world, 1.0 / 60).ok());
  const sim::PairTable& table = world.state().pairs;
  Pairs found;
  for (std::size_t k = 0; k < table.size(); ++k) found.emplace_back(table.a[k], table.b[k]);
  EXPECT_EQ(found, all_overlaps(world.scratch()));
}

// n boxes of sizes between the two, in a room of the given size.
SceneDef room(std::uint32_t n, const Vec3& size, double smallest, double largest, std::uint64_t seed) {
  Random random(seed);
  SceneDef scene = empty_space();
  for (sim::BodyId id = 1; id <= n; ++id) {
    const auto along = [&](double length) { return random.uniform(-length / 2, length / 2); };
    const auto edge = [&] { return random.uniform(smallest, largest); };
    sim::BoxDef b = box(id, {edge(), edge(), edge()}, {along(size.x()), along(size.y()), along(size.z())});
    b.orientation = random.rotation();
    b.velocity = {along(20), along(20), along(20)};
    scene.boxes.push_back(b);
  }
  return scene;
}

TEST(FindNearPairs, FindsWhatLookingAtEveryPairFinds) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    expect_all_found(room(300, {20, 20, 20}, 0.5, 2, seed));   // spread out
    expect_all_found(room(600, {100, 3, 3}, 0.5, 1, seed));    // in a row
    expect_all_found(room(600, {8, 8, 8}, 0.5, 1, seed));      // crowded: cells
    expect_all_found(room(400, {30, 30, 30}, 0.1, 25, seed));  // large among small
  }
}

TEST(FindNearPairs, FindsAllInExactLattices) {
  expect_all_found(tilted_grid(12));
  expect_all_found(pile(8));
  expect_all_found(tower(60));
}

TEST(FindNearPairs, OneBoxFarAwayCostsNoMemory) {
  SceneDef scene = pile(8);
  scene.boxes.push_back(cube(9999, {30000, -30000, 30000}));
  expect_all_found(scene);
}

TEST(FindNearPairs, FewBodiesAndNone) {
  expect_all_found(empty_space());
  expect_all_found(room(1, {1, 1, 1}, 1, 1, 1));
  expect_all_found(room(47, {4, 4, 4}, 0.5, 2, 1));
  expect_all_found(room(49, {4, 4, 4}, 0.5, 2, 1));
}

// n bodies in one place have n² / 2 pairs: a few kilobytes of scene would fill any memory.
TEST(FindNearPairs, ACrowdInOnePlaceIsRefused) {
  for (const auto& [method, bodies, what] : {std::tuple(sim::Method::kLayered, 400U, "contacts of 400 bodies"),
                                             std::tuple(sim::Method::kLayered, 1800U, "pairs of 1800 bodies"),
                                             std::tuple(sim::Method::kThesis, 1800U, "pairs of 1800 bodies")}) {
    SceneDef scene = empty_space();
    scene.world.method = method;
    for (sim::BodyId id = 1; id <= bodies; ++id) {
      scene.boxes.push_back(cube(id, {0, 0, 1e-3 * static_cast<double>(id)}));
    }
    World world = made(scene);
    const auto stepped = sim::step(world, nullptr);
    ASSERT_FALSE(stepped.ok());
    EXPECT_EQ(stepped.error().kind, ErrorKind::kCannotFinish);
    EXPECT_NE(stepped.error().message.find(what), std::string::npos) << stepped.error().message;
  }
}

}  // namespace
}  // namespace tumble::test
