// Thesis III.A.1: dynamically sized AABBs and the Active Collision List.
#include "src/thesis/find_pairs.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <set>
#include <utility>

#include "src/collide/sweep.h"
#include "src/math/grid.h"
#include "src/world/scratch.h"
#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::BodyIndex;
using sim::PairTable;
using sim::PositionGrid;
using sim::SceneDef;
using sim::Vec3;
using sim::World;

const double kHalfRoot = std::sqrt(0.5);

World two_cubes(const Vec3& second) {
  SceneDef scene = empty_space();
  scene.boxes = {cube(1, {0, 0, 0}), cube(2, second)};
  return made(scene);
}

std::size_t pair_count(World& world) {
  EXPECT_TRUE(test::run_phase(sim::find_pairs, world, 0).ok());
  return world.state().pairs.size();
}

// Half the AABB's size, which is position ± reach; rounded outwards by at most two grid steps.
void expect_reach(const World& world, BodyIndex i, const Vec3& wanted) {
  const Vec3 above = world.scratch().aabb_high[i] - world.bodies().position[i];
  const Vec3 below = world.bodies().position[i] - world.scratch().aabb_low[i];
  EXPECT_EQ(above, below);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_GE(above[axis], wanted[axis] - 1e-15) << axis;
    EXPECT_LE(above[axis], wanted[axis] + 2 * PositionGrid::kStep) << axis;
  }
}

// Thesis Fig. 4. A 2 × 1 × 1 m box has half extents 1, ½, ½. Turned 45° about z its farthest corner along x and along
// y lies (1 + ½)·√½ out; z stays.
TEST(FindPairs, AabbGrowsWhenTheBoxTurns) {
  SceneDef scene = empty_space();
  scene.boxes = {box(1, {2, 1, 1}, {3, -2, 5}), box(2, {2, 1, 1}, {-3, 2, 5})};
  scene.boxes[1].orientation = turn({0, 0, 1}, kHalfRoot, kHalfRoot);
  World world = made(scene);
  update_frames(world.mutable_state().bodies, world.mutable_scratch());
  expect_reach(world, 0, {1, 0.5, 0.5});
  expect_reach(world, 1, {1.5 * kHalfRoot, 1.5 * kHalfRoot, 0.5});
}

// "The x-y-z extents of the actual geometry's vertices are calculated for every time step giving the tightest AABB":
// the largest of the eight corners, each turned as v + 2w(u × v) + 2u × (u × v).
TEST(FindPairs, AabbIsTheTightestAroundTheCornersAtEveryStep) {
  SceneDef scene = tumble_of_boxes(3, 5);
  scene.world = empty_space().world;
  World world = made(scene);
  for (int step = 0; step < 20; ++step) {
    advance(world);
    update_frames(world.mutable_state().bodies, world.mutable_scratch());
    for (BodyIndex i = 0; i < world.bodies().size(); ++i) {
      const sim::Quat q = world.bodies().orientation[i];
      const Vec3 u(q.x, q.y, q.z), h = world.bodies().half_extent[i];
      Vec3 reach = Vec3::Zero();
      for (int corner = 0; corner < 8; ++corner) {
        const Vec3 v((corner & 1) != 0 ? h.x() : -h.x(), (corner & 2) != 0 ? h.y() : -h.y(),
                     (corner & 4) != 0 ? h.z() : -h.z());
        const Vec3 turned = v + 2 * q.w * u.cross(v) + 2 * u.cross(u.cross(v));
        reach = reach.cwiseMax(turned);
      }
      expect_reach(world, i, reach);
    }
  }
}

// Unit cubes overlap along an axis when their centres are less than 1 m apart on it; all three are needed.
TEST(FindPairs, PairIsListedOnlyWhenAabbsOverlapOnAllThreeAxes) {
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 near(0.5, 0.5, 0.5), far = near;
    near[axis] = 0.999;
    far[axis] = 1.001;
    World overlapping = two_cubes(near), apart = two_cubes(far);
    EXPECT_EQ(pair_count(overlapping), 1U) << axis;
    EXPECT_EQ(pair_count(apart), 0U) << axis;
  }
}

// "Strictly satisfies the fact that there can not be any real colliding pair that is not in the ACL": touching boxes
// are in it. Two cubes turned 45° about z overlap as AABBs (reach √½) where the boxes themselves are apart.
TEST(FindPairs, ListHoldsTouchingAndMerelyBoundedPairs) {
  World touching = two_cubes({1, 0, 0});
  EXPECT_EQ(pair_count(touching), 1U);
  SceneDef scene = empty_space();
  scene.boxes = {cube(1, {0, 0, 0}), cube(2, {1.2, 1.2, 0})};
  for (sim::BoxDef& b : scene.boxes) b.orientation = turn({0, 0, 1}, kHalfRoot, kHalfRoot);
  World turned = made(scene);
  EXPECT_EQ(pair_count(turned), 1U);
}

// Against every pair of AABBs compared directly, in clouds that spread along x, y and z by turns, and while they move.
TEST(FindPairs, SweepFindsWhatComparingAllPairsFinds) {
  for (int axis = 0; axis < 3; ++axis) {
    SceneDef scene = tumble_of_boxes(4, 17);
    scene.world = empty_space().world;
    for (sim::BoxDef& b : scene.boxes) b.position[axis] *= 2;
    World world = made(scene);
    std::size_t seen = 0;
    for (int step = 0; step < 30; ++step) {
      advance(world);  // on ground-less space: moves all and keeps the last swept order
      ASSERT_TRUE(test::run_phase(sim::find_pairs, world, 0).ok());
      std::set<std::pair<BodyIndex, BodyIndex>> wanted;
      const auto& low = world.scratch().aabb_low;
      const auto& high = world.scratch().aabb_high;
      for (BodyIndex a = 0; a < world.bodies().size(); ++a) {
        for (BodyIndex b = a + 1; b < world.bodies().size(); ++b) {
          const bool overlap = (low[a].array() <= high[b].array()).all() && (low[b].array() <= high[a].array()).all();
          if (overlap) wanted.emplace(a, b);
        }
      }
      const PairTable& pairs = world.state().pairs;
      ASSERT_EQ(pairs.size(), wanted.size());
      std::size_t k = 0;
      for (const auto& [a, b] : wanted) {  // a set is sorted, and so must the list be
        EXPECT_EQ(pairs.a[k], a);
        EXPECT_EQ(pairs.b[k], b);
        ++k;
      }
      seen += pairs.size();
    }
    EXPECT_GT(seen, 100U) << "hardly any pairs: the test proves nothing";
  }
}

// Neighbours are kept while every box is in its room: leaving it on any side is noticed.
TEST(FindPairs, BoxThatCrossesToAnotherIsFoundFromEverySide) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Vec3 far = Vec3::Zero(), near = Vec3::Zero();
      far[axis] = 3 * side;
      near[axis] = 0.9 * side;
      World world = two_cubes(far);
      EXPECT_EQ(pair_count(world), 0U);
      world.mutable_state().bodies.position.set(1, near);
      EXPECT_EQ(pair_count(world), 1U) << "axis " << axis << ", side " << side;
      world.mutable_state().bodies.position.set(1, far);
      EXPECT_EQ(pair_count(world), 0U);
    }
  }
}

// Within a step only what could not move keeps its box: one that wakes takes it along, and so does one that freezes.
TEST(FindPairs, BoxOfABodyThatWakesOrFreezesWithinAStepMovesAlong) {
  World world = two_cubes({3, 0, 0});
  sim::Bodies& bodies = world.mutable_state().bodies;
  bodies.frozen[1] = 1;
  bodies.frozen[0] = 1;                         // boxes are put in lanes: two are skipped or put together
  world.mutable_scratch().framed.assign(2, 0);  // as a step begins
  EXPECT_EQ(pair_count(world), 0U);
  bodies.frozen[1] = 0;
  bodies.position.set(1, {0.9, 0, 0});
  EXPECT_EQ(pair_count(world), 1U) << "it has woken";
  bodies.position.set(1, {3, 0, 0});
  bodies.frozen[1] = 1;
  EXPECT_EQ(pair_count(world), 0U) << "it has been moved and has frozen since";
}

// "The caching of SP starts when the pair is inserted into the ACL and stops when the pair leaves the ACL."
TEST(FindPairs, PlanesAreKeptWhileListedAndLostWhenThePairLeaves) {
  SceneDef scene = empty_space();
  scene.boxes = {cube(1, {0, 0, 0}), cube(2, {0.9, 0.9, 0}), cube(3, {-0.9, 0, 0})};
  World world = made(scene);
  ASSERT_EQ(pair_count(world), 2U);  // 1-2 and 1-3
  EXPECT_EQ(world.state().pairs.planes, (std::vector<std::uint16_t>{0, 0}));
  world.mutable_state().pairs.planes = {0b10, 0b1};

  world.mutable_state().bodies.position.set(2, {0, 0, 9});
  ASSERT_EQ(pair_count(world), 1U);
  EXPECT_EQ(world.state().pairs.planes[0], 0b10) << "1-2 has stayed in the list";

  world.mutable_state().bodies.position.set(2, {-0.9, 0, 0});
  ASSERT_EQ(pair_count(world), 2U);
  EXPECT_EQ(world.state().pairs.planes, (std::vector<std::uint16_t>{0b10, 0})) << "1-3 has left it";
}

}  // namespace
}  // namespace tumble::test
