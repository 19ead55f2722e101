// Thesis III.A.2: separating planes, the Real Collision List, and the planes that displacement makes false.
#include "src/thesis/find_planes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "src/collide/box_pair.h"
#include "src/collide/sweep.h"
#include "src/thesis/find_pairs.h"
#include "src/thesis/recheck_planes.h"
#include "src/world/scratch.h"
#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::AxisSet;
using sim::BoxDef;
using sim::kEdges;
using sim::kFaces;
using sim::kFacesOfA;
using sim::kFacesOfB;
using sim::kGround;
using sim::only;
using sim::SceneDef;
using sim::Vec3;
using sim::World;

const double kHalfRoot = std::sqrt(0.5);

const Vec3 kDown(0, 0, -10);

// A world of two boxes that are a pair with these old planes, whether or not their AABBs overlap.
World paired(const BoxDef& a, const BoxDef& b, AxisSet old, const Vec3& gravity = kDown) {
  SceneDef scene = empty_space();
  scene.world.gravity = gravity;
  scene.boxes = {a, b};
  World world = made(scene);
  update_frames(world.mutable_state().bodies, world.mutable_scratch());
  world.mutable_state().pairs = {{0}, {1}, {old}};
  return world;
}

AxisSet plane_after(const BoxDef& a, const BoxDef& b, AxisSet old, const Vec3& gravity = kDown) {
  World world = paired(a, b, old, gravity);
  EXPECT_TRUE(test::run_phase(sim::find_planes, world, 0).ok());
  return world.state().pairs.planes[0];
}

// The planes of the collision, or 0 when there is none.
AxisSet collision_after(const BoxDef& a, const BoxDef& b, AxisSet old) {
  World world = paired(a, b, old);
  EXPECT_TRUE(test::run_phase(sim::find_planes, world, 0).ok());
  const sim::Contacts& contacts = world.scratch().contacts;
  EXPECT_FALSE(world.state().pairs.planes[0] != 0 && !contacts.a.empty()) << "a plane or a collision, never both";
  return contacts.a.empty() ? AxisSet{0} : contacts.planes[0];
}

// Turned about an axis along none of the cube's edges and diagonals, so that faces and edges all separate differently.
BoxDef skew(sim::BodyId id, const Vec3& position) {
  BoxDef made = cube(id, position);
  made.orientation = {0.8, 0.3, 0.4, 0.2};
  return made;
}

// Cubes (1.75, 1.25, 0.125) apart: gaps of 0.75 along x and 0.25 along y.
TEST(FindPlanes, PlaneThatStillSeparatesIsKeptThoughABetterOneExists) {
  const BoxDef a = cube(1, {0, 0, 0}), b = cube(2, {1.75, 1.25, 0.125});
  EXPECT_EQ(plane_after(a, b, only(1)), only(1));
  EXPECT_EQ(plane_after(a, b, only(4)), only(4));
  EXPECT_EQ(plane_after(a, b, only(0) | only(3)), only(0) | only(3)) << "tied planes stay tied";
  EXPECT_EQ(plane_after(a, b, only(1) | only(2)), only(1)) << "of tied planes those that separate stay";
}

TEST(FindPlanes, WithoutAnOldPlaneTheBestFacesAreTaken) {
  EXPECT_EQ(plane_after(cube(1, {0, 0, 0}), cube(2, {1.75, 1.25, 0}), 0), only(0) | only(3));
}

// Centres (2, 1.5, 1) apart leave both faces and edges to choose from, but not every one: a's z faces overlap.
TEST(FindPlanes, SearchAlternatesBetweenFacesAndEdges) {
  const BoxDef a = cube(1, {0, 0, 0}), b = skew(2, {2, 1.5, 1});
  const World world = paired(a, b, 0);
  const sim::BoxPair pair(world.scratch().frames[0], world.scratch().frames[1]);
  ASSERT_NE(pair.separating(kFaces), 0);
  ASSERT_NE(pair.separating(kEdges), 0);
  AxisSet bad_face = 0, bad_edge = 0;
  for (int axis = 0; axis < 15; ++axis) {
    if (pair.separating(only(axis)) == 0) (axis < 6 ? bad_face : bad_edge) = only(axis);
  }
  ASSERT_NE(bad_face, 0);
  ASSERT_NE(bad_edge, 0);
  const auto is_in = [](AxisSet axes, AxisSet kind) { return axes != 0 && (axes & ~kind) == 0; };
  EXPECT_TRUE(is_in(plane_after(a, b, bad_face), kEdges)) << "after a face plane, edges first";
  EXPECT_TRUE(is_in(plane_after(a, b, bad_edge), kFaces)) << "after an edge plane, faces first";
  EXPECT_TRUE(is_in(plane_after(a, b, 0), kFaces)) << "without a plane, faces first";
}

// Where the first kind has nothing, the other is searched. Aligned cubes have no edge axes at all; crossed beams on
// their edges 1.5 m apart, where only the edge axis 7 (x × y) separates, by 1.5 − √2.
TEST(FindPlanes, SearchGoesOnWithTheOtherKind) {
  EXPECT_EQ(plane_after(cube(1, {0, 0, 0}), cube(2, {0.25, 0.125, 1.5}), only(0)), only(2));
  BoxDef a = box(1, {4, 1, 1}, {0, 0, 0}), b = box(2, {1, 4, 1}, {0.3, 0.2, 1.5});
  a.orientation = turn({1, 0, 0}, kHalfRoot, kHalfRoot);
  b.orientation = turn({0, 1, 0}, kHalfRoot, kHalfRoot);
  EXPECT_EQ(plane_after(a, b, 0), only(7));
  EXPECT_EQ(plane_after(a, b, only(8)), only(7));
}

// Fig. 5 b. A 4 m cube turned 10° about z and a unit cube at (3.2, −1.5, 0.1). Gap on the small one's x face:
// 3.2 − ½ − 2 (cos 10° + sin 10°) = 0.383; on the large one's: 3.2 cos 10° − 1.5 sin 10° − 2 − ½ (cos 10° + sin 10°) =
// 0.312. The small one's is wider, and the large one's is taken, whichever comes first.
TEST(FindPlanes, FacesOfTheLargerBoxComeFirst) {
  const double angle = 10 * std::acos(-1) / 180;
  BoxDef large = box(1, {4, 4, 4}, {0, 0, 0}), small = box(2, {1, 1, 1}, {3.2, -1.5, 0.1});
  large.orientation = turn({0, 0, 1}, std::cos(angle), std::sin(angle));
  EXPECT_EQ(plane_after(large, small, 0), only(0));
  large.id = 2;
  small.id = 1;
  EXPECT_EQ(plane_after(small, large, 0), only(3));
}

// Equal volumes: the lower one's first, and on equal height both together.
TEST(FindPlanes, OfEqualBoxesTheLowerOnesFacesComeFirst) {
  for (const double height : {0.25, -0.25, 0.0}) {
    const AxisSet found = plane_after(cube(1, {0, 0, 0}), skew(2, {2, 1.5, height}), 0);
    const AxisSet wanted = height > 0 ? kFacesOfA : height < 0 ? kFacesOfB : kFaces;
    EXPECT_NE(found, 0);
    EXPECT_EQ(found & ~wanted, 0) << "height " << height;
  }
}

// Lower is along gravity, wherever gravity points; without gravity no box is lower, and both boxes' faces are searched.
TEST(FindPlanes, LowerIsAlongGravity) {
  const BoxDef a = cube(1, {0, 0, 0}), b = skew(2, {2, 1.5, 0.25});
  EXPECT_EQ(plane_after(a, b, 0, {0, 0, 10}) & ~kFacesOfB, 0);
  EXPECT_EQ(plane_after(a, b, 0, {-3, 0, 0}) & ~kFacesOfA, 0);
  EXPECT_EQ(plane_after(a, b, 0, {0, 4, -10}) & ~kFacesOfB, 0) << "1.5 · 4 outweighs 0.25 · 10";
  const BoxDef level = cube(2, {1.5, 0.25, 0.125});
  EXPECT_EQ(plane_after(cube(1, {0, 0, 0}), level, 0), only(0));
  EXPECT_EQ(plane_after(cube(1, {0, 0, 0}), level, 0, {0, 0, 0}), only(0) | only(3));
}

// "If there is a real collision and an old SP is present, the collision happens on that SP": overlaps 0.2 along x and
// 0.1 along y, the old plane was x.
TEST(FindPlanes, CollisionHappensOnTheOldPlane) {
  const BoxDef a = cube(1, {0, 0, 0}), b = cube(2, {0.8, 0.9, 0.25});
  EXPECT_EQ(collision_after(a, b, only(0)), only(0));
  EXPECT_EQ(collision_after(a, b, only(3)), only(3));
}

// No old plane (a collision in the last step, new in the list): the plane of least overlap. The lower box's face first.
TEST(FindPlanes, CollisionWithoutAnOldPlaneHappensOnThePlaneOfLeastOverlap) {
  EXPECT_EQ(collision_after(cube(1, {0, 0, 0}), cube(2, {0.7, 0.9, 0.25}), 0), only(1));
  EXPECT_EQ(collision_after(cube(1, {0, 0, 0}), cube(2, {0.7, 0.9, -0.25}), 0), only(4));
  EXPECT_EQ(collision_after(cube(1, {0, 0, 0}), cube(2, {0.7, 0.9, 0}), 0), only(1) | only(4));
}

// An old plane overlapped by more than half of the smallest half extent (0.25 m here) is not believed any more.
TEST(FindPlanes, OldPlaneThatTheBoxesHaveTurnedPastIsNotBelieved) {
  EXPECT_EQ(collision_after(cube(1, {0, 0, 0}), cube(2, {0.76, 0.9, 0.25}), only(0)), only(0));
  EXPECT_EQ(collision_after(cube(1, {0, 0, 0}), cube(2, {0.74, 0.9, 0.25}), only(0)), only(1));
}

// Crossed bars of 4 × 0.1 × 0.1 m, a little out of parallel: often the only axis that shows them apart lies within 2.6°
// of a face normal. It is no plane to collide on, but there is nothing to collide.
TEST(FindPlanes, WhatOnlyAFacelikeEdgeAxisSeparatesDoesNotCollide) {
  Random random(5);
  int apart = 0;
  for (int k = 0; k < 4000; ++k) {
    BoxDef a = box(1, {4, 0.1, 0.1}, {0, 0, 0}), b = box(2, {4, 0.1, 0.1}, {0, 0, 0});
    b.orientation = {1, random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02), random.uniform(-1, 1)};
    b.position = {random.uniform(-1, 1), random.uniform(-0.3, 0.3), random.uniform(0.1, 0.15)};
    World world = paired(a, b, 0);
    const sim::BoxPair pair(world.scratch().frames[0], world.scratch().frames[1]);
    if (!pair.apart_along_facelike_edges() || pair.separating(kFaces | kEdges) != 0) continue;
    ++apart;
    EXPECT_EQ(collision_after(a, b, 0), 0) << "trial " << k;
    EXPECT_EQ(plane_after(a, b, 0), 0) << "trial " << k;
  }
  EXPECT_GT(apart, 10) << "the case must have come up";
}

TEST(FindPlanes, TouchingIsNotColliding) {
  EXPECT_EQ(collision_after(cube(1, {0, 0, 0}), cube(2, {1, 0.25, 0.25}), 0), 0);
  EXPECT_NE(collision_after(cube(1, {0, 0, 0}), cube(2, {1 - 0x1p-36, 0.25, 0.25}), 0), 0);
}

// Crossed beams on edge, 1.3 m apart: they overlap by √2 − 1.3 = 0.114 along the edge axis and far more along any face.
TEST(FindPlanes, EdgeCollisionIsFoundWithoutAnOldPlane) {
  BoxDef a = box(1, {4, 1, 1}, {0, 0, 0}), b = box(2, {1, 4, 1}, {0.3, 0.2, 1.3});
  a.orientation = turn({1, 0, 0}, kHalfRoot, kHalfRoot);
  b.orientation = turn({0, 1, 0}, kHalfRoot, kHalfRoot);
  EXPECT_EQ(collision_after(a, b, 0), only(7));
}

TEST(FindPlanes, PairsThatCannotMoveAreLeftAlone) {
  BoxDef a = cube(1, {0, 0, 0}), b = cube(2, {0.5, 0.25, 0.25});
  a.is_static = true;
  b.frozen = true;
  World world = paired(a, b, only(5));
  ASSERT_TRUE(test::run_phase(sim::find_planes, world, 0).ok());
  EXPECT_TRUE(world.scratch().contacts.a.empty());
  EXPECT_EQ(world.state().pairs.planes[0], only(5));
}

// A cube collides with the ground when its lowest corner is below z = 0: at ½ it touches. Frozen and static ones rest.
TEST(FindPlanes, GroundCollidesWithWhatReachesBelowIt) {
  SceneDef scene = on_ground();
  scene.boxes = {cube(1, {0, 0, 0.5}), cube(2, {3, 0, 0.5 - 0x1p-36}), cube(3, {6, 0, 0.25}), cube(4, {9, 0, 0.25})};
  scene.boxes[2].frozen = true;
  scene.boxes[3].is_static = true;
  World world = made(scene);
  ASSERT_TRUE(test::run_phase(sim::find_pairs, world, 0).ok());
  ASSERT_TRUE(test::run_phase(sim::find_planes, world, 0).ok());
  EXPECT_EQ(world.scratch().contacts.a, (std::vector<sim::BodyIndex>{1}));
  EXPECT_EQ(world.scratch().contacts.b, (std::vector<sim::BodyIndex>{kGround}));

  world.mutable_state().def.ground = false;
  ASSERT_TRUE(test::run_phase(sim::find_planes, world, 0).ok());
  EXPECT_TRUE(world.scratch().contacts.a.empty());
}

// Old planes are tested without all that a BoxPair works out; no bit may show it.
TEST(FindPlanes, FacesAloneSeparateAsInABoxPair) {
  Random random(31);
  int apart = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const auto size = [&] {
      const double x = random.uniform(0.5, 2), y = random.uniform(0.5, 2);
      return Vec3(x, y, random.uniform(0.5, 2));
    };
    const bool grid = trial % 4 == 0;  // touches, ties and zero offsets
    const double x = random.uniform(-2, 2), y = random.uniform(-2, 2), z = random.uniform(-2, 2);
    const Vec3 offset = grid ? Vec3(std::round(x), std::round(y), std::round(z)) : Vec3(x, y, z);
    BoxDef a = grid ? cube(1, {0, 0, 0}) : box(1, size(), {0, 0, 0});
    BoxDef b = grid ? cube(2, offset) : box(2, size(), offset);
    if (!grid) a.orientation = random.rotation();
    if (!grid) b.orientation = random.rotation();
    const World world = paired(a, b, 0);
    const auto& frames = world.scratch().frames;
    const sim::BoxPair pair(frames[0], frames[1]);
    for (unsigned set = 0; set < 64; ++set) {
      const auto faces = static_cast<AxisSet>(set);
      ASSERT_EQ(separating(frames[0], frames[1], faces), pair.separating(faces)) << "trial " << trial;
      if (pair.separating(faces) != 0) ++apart;
    }
    EXPECT_EQ(separating(frames[0], frames[1], kEdges | kFaces), pair.separating(kEdges | kFaces));
  }
  EXPECT_GT(apart, 10000);
}

// "The existing SP is re-checked to be sure that it is still separating": after displacement it may not.
TEST(RecheckPlanes, PlaneThatDisplacementMadeFalseIsForgotten) {
  World world = paired(cube(1, {0, 0, 0}), cube(2, {1.25, 1.25, 0}), only(0) | only(1));
  world.mutable_scratch().touched = {0, 1};
  ASSERT_TRUE(test::run_phase(sim::recheck_planes, world, 0).ok());
  EXPECT_EQ(world.state().pairs.planes[0], only(0) | only(1)) << "nothing has moved";

  world.mutable_state().bodies.position.set(1, {0.875, 1.25, 0});
  ASSERT_TRUE(test::run_phase(sim::recheck_planes, world, 0).ok());
  EXPECT_EQ(world.state().pairs.planes[0], only(1));

  world.mutable_state().bodies.position.set(1, {0.875, 0.875, 0});
  ASSERT_TRUE(test::run_phase(sim::recheck_planes, world, 0).ok());
  EXPECT_EQ(world.state().pairs.planes[0], 0);
}

}  // namespace
}  // namespace tumble::test
