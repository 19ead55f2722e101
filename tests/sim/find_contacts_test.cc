// Thesis III.A.2, second goal: collision points, Figs. 5 and 6. Expected points are worked out in the comments.
#include "src/thesis/find_contacts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "src/collide/box_pair.h"
#include "src/thesis/find_pairs.h"
#include "src/thesis/find_planes.h"
#include "src/world/scratch.h"
#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::AxisSet;
using sim::BoxDef;
using sim::Contacts;
using sim::kGround;
using sim::only;
using sim::SceneDef;
using sim::Vec3;
using sim::World;

const double kHalfRoot = std::sqrt(0.5);

void expect_near(const Vec3& found, const Vec3& wanted, double tolerance = 1e-9) {
  EXPECT_LT((found - wanted).cwiseAbs().maxCoeff(), tolerance)
      << "found " << found.transpose() << ", wanted " << wanted.transpose();
}

World in_the_ground(const BoxDef& body) {
  SceneDef scene = on_ground();
  scene.boxes = {body};
  World world = made(scene);
  EXPECT_TRUE(test::run_phase(sim::find_pairs, world, 0).ok());
  EXPECT_TRUE(test::run_phase(sim::find_planes, world, 0).ok());
  EXPECT_TRUE(test::run_phase(sim::find_contacts, world, 0).ok());
  return world;
}

// The collision of two boxes on given planes, or (planes = 0) on those that find_planes chooses.
World colliding(const BoxDef& a, const BoxDef& b, AxisSet planes = 0, const Vec3& gravity = {0, 0, 0}) {
  SceneDef scene = empty_space();
  scene.world.gravity = gravity;
  scene.boxes = {a, b};
  World world = made(scene);
  EXPECT_TRUE(test::run_phase(sim::find_pairs, world, 0).ok());
  EXPECT_TRUE(test::run_phase(sim::find_planes, world, 0).ok());
  if (planes != 0) world.mutable_scratch().contacts.planes = {planes};
  EXPECT_TRUE(test::run_phase(sim::find_contacts, world, 0).ok());
  return world;
}

// Fig. 6 a: a cube 0.1 m deep in the ground falls on one point just beneath its centre.
TEST(FindContacts, FlatFallMeetsOnePointBeneathTheCentre) {
  const World world = in_the_ground(cube(1, {3, -2, 0.4}));
  const Contacts& contacts = world.scratch().contacts;
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts.a[0], 0U);
  EXPECT_EQ(contacts.b[0], kGround);
  EXPECT_EQ(contacts.r_a[0], Vec3(0, 0, -0.5)) << "to the bit: opposite corners cancel";
  EXPECT_EQ(contacts.normal[0], Vec3(0, 0, -1));
  EXPECT_NEAR(contacts.depth[0], 0.1, 1e-10);
}

// Fig. 6 b: a unit cube turned about y by the angle with cosine 0.96 and sine 0.28. A corner (x, y, −½) of the body
// goes to (0.96 x − 0.14, y, −0.28 x − 0.48): x = ½ to (0.34, y, −0.62), x = −½ to (−0.62, y, −0.34). With the centre
// at 0.3 they are 0.32 and 0.04 deep, so the point is at x = (0.32·0.34 − 0.04·0.62) / 0.36 = 0.084 / 0.36 and z =
// −(0.32·0.62 + 0.04·0.34) / 0.36 = −0.212 / 0.36.
TEST(FindContacts, PointIsWeightedByPenetration) {
  BoxDef body = cube(1, {0, 0, 0.3});
  body.orientation = turn({0, 1, 0}, 0.96, 0.28);
  const World world = in_the_ground(body);
  const Contacts& contacts = world.scratch().contacts;
  ASSERT_EQ(contacts.size(), 1U);
  expect_near(contacts.r_a[0], {0.084 / 0.36, 0, -0.212 / 0.36});
  EXPECT_NEAR(contacts.depth[0], 0.32, 1e-10);
}

// The same cube higher up: only the edge at x = ½ is in the ground, and its middle is the point.
TEST(FindContacts, CornersInFrontOfThePlaneDoNotCount) {
  BoxDef body = cube(1, {0, 0, 0.5});
  body.orientation = turn({0, 1, 0}, 0.96, 0.28);
  const World world = in_the_ground(body);
  ASSERT_EQ(world.scratch().contacts.size(), 1U);
  expect_near(world.scratch().contacts.r_a[0], {0.34, 0, -0.62});
  EXPECT_NEAR(world.scratch().contacts.depth[0], 0.12, 1e-10);
}

// Fig. 5: a unit cube 0.05 m deep in a slab of 10 × 10 × 1 m, at (3, 2) from its centre. On the slab's plane (b) the
// four lower corners of the cube are behind: the point lies under the cube, whichever of the two is called a. On the
// cube's plane (a) it would be under the slab's centre.
TEST(FindContacts, SmallBoxMeetsABigOneWhereItStands) {
  BoxDef slab = box(1, {10, 10, 1}, {0, 0, -0.5}), small = cube(2, {3, 2, 0.45});
  const World world = colliding(slab, small);
  const Contacts& contacts = world.scratch().contacts;
  ASSERT_EQ(contacts.size(), 1U);
  expect_near(contacts.r_a[0], {3, 2, 0.45});
  expect_near(contacts.r_b[0], {0, 0, -0.5});
  expect_near(contacts.normal[0], {0, 0, 1});
  EXPECT_NEAR(contacts.depth[0], 0.05, 1e-10);

  std::swap(slab.id, small.id);
  const World other_way = colliding(small, slab);
  expect_near(other_way.scratch().contacts.r_b[0], {3, 2, 0.45});
  expect_near(other_way.scratch().contacts.normal[0], {0, 0, -1});
}

// A cube that overhangs the slab's edge: the plane is infinite, so all four corners count ("some points penetrating
// that plane are not necessarily penetrating the actual face").
TEST(FindContacts, PlaneOfAFaceIsInfinite) {
  const World world = colliding(box(1, {10, 10, 1}, {0, 0, -0.5}), cube(2, {5.25, 0, 0.45}));
  ASSERT_EQ(world.scratch().contacts.size(), 1U);
  expect_near(world.scratch().contacts.r_a[0], {5.25, 0, 0.45});
}

// A static slab carries only what lies over its face: the point stays at the edge, x = 5, and so do the corners that
// share the load, whichever of the two is called a.
TEST(FindContacts, PointStaysOnTheFaceOfAStaticBox) {
  BoxDef slab = box(1, {10, 10, 1}, {0, 0, -0.5}), over = cube(2, {5.25, 0, 0.45});
  slab.is_static = true;
  const World world = colliding(slab, over);
  const Contacts& contacts = world.scratch().contacts;
  ASSERT_EQ(contacts.size(), 1U);
  expect_near(contacts.r_a[0], {5, 0, 0.45});
  EXPECT_NEAR(contacts.depth[0], 0.05, 1e-10);
  ASSERT_EQ(contacts.patch.size(), 4U);
  for (const Vec3& corner : contacts.patch) EXPECT_LE(corner.x(), 1e-9);

  std::swap(slab.id, over.id);
  expect_near(colliding(over, slab).scratch().contacts.r_b[0], {5, 0, 0.45});
}

// Beams along x and y, each standing on an edge, 1.3 m apart. The upper edge of a runs along x at y = 0, z = √½; the
// lower edge of b along y at x = 0.3, z = 1.3 − √½. They are nearest at (0.3, 0), and half-way up lies 0.65.
TEST(FindContacts, EdgesMeetInTheMiddleOfTheShortestLine) {
  BoxDef a = box(1, {4, 1, 1}, {0, 0, 0}), b = box(2, {1, 4, 1}, {0.3, 0.2, 1.3});
  a.orientation = turn({1, 0, 0}, kHalfRoot, kHalfRoot);
  b.orientation = turn({0, 1, 0}, kHalfRoot, kHalfRoot);
  const World world = colliding(a, b);
  const Contacts& contacts = world.scratch().contacts;
  ASSERT_EQ(contacts.size(), 1U);
  ASSERT_EQ(contacts.planes[0], only(7));
  expect_near(contacts.r_a[0], {0.3, 0, 0.65});
  expect_near(contacts.r_b[0], {0, -0.2, -0.65});
  expect_near(contacts.normal[0], {0, 0, 1});
  EXPECT_NEAR(contacts.depth[0], 2 * kHalfRoot - 1.3, 1e-10);
}

// The edges as lines would be nearest at x = 2.1, 0.1 beyond the end of a; the point on a stays at its end.
TEST(FindContacts, PointOnAnEdgeDoesNotLeaveTheEdge) {
  BoxDef a = box(1, {4, 1, 1}, {0, 0, 0}), b = box(2, {1, 4, 1}, {2.1, 0.2, 1.3});
  a.orientation = turn({1, 0, 0}, kHalfRoot, kHalfRoot);
  b.orientation = turn({0, 1, 0}, kHalfRoot, kHalfRoot);
  const World world = colliding(a, b, only(7));
  ASSERT_EQ(world.scratch().contacts.size(), 1U);
  expect_near(world.scratch().contacts.r_a[0], {(2 + 2.1) / 2, 0, 0.65});
}

// Equal cubes (0.9, 0.9, 0) apart overlap by 0.1 along x and y, on both boxes' faces: four planes tie. On a's x face
// the corners of b at x = 0.4 count, mean (0.4, 0.9, 0); on b's x face those of a at x = ½, mean (½, 0, 0); likewise
// for y. The mean of the four is (0.45, 0.45, 0), the mean normal the diagonal.
TEST(FindContacts, TiedPlanesGiveTheMeanPointAndNormal) {
  const World world = colliding(cube(1, {0, 0, 0}), cube(2, {0.9, 0.9, 0}));
  const Contacts& contacts = world.scratch().contacts;
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts.planes[0], only(0) | only(1) | only(3) | only(4));
  expect_near(contacts.r_a[0], {0.45, 0.45, 0});
  expect_near(contacts.normal[0], {kHalfRoot, kHalfRoot, 0}, 1e-15);
  EXPECT_EQ(contacts.normal[0].x(), contacts.normal[0].y());
  EXPECT_NEAR(contacts.depth[0], 0.1, 1e-10);
}

// Both offsets mean the same point, whatever the boxes: what conserves angular momentum.
TEST(FindContacts, OffsetsFromBothCentresMeetInOnePoint) {
  Random random(3);
  std::size_t seen = 0;
  for (int trial = 0; trial < 300; ++trial) {
    BoxDef a = cube(1, {0, 0, 0}), b = cube(2, {0.8, random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)});
    a.orientation = random.rotation();
    b.orientation = random.rotation();
    const World world = colliding(a, b);
    const Contacts& contacts = world.scratch().contacts;
    for (std::size_t k = 0; k < contacts.size(); ++k, ++seen) {
      const Vec3 d = world.bodies().position[1] - world.bodies().position[0];
      EXPECT_EQ(contacts.r_a[k] - contacts.r_b[k], d);
      EXPECT_GT(contacts.depth[k], 0);
      EXPECT_GT(contacts.normal[k].dot(d), 0);
      EXPECT_NEAR(contacts.normal[k].norm(), 1, 1e-14);
    }
  }
  EXPECT_GT(seen, 200U);
}

// Boxes in one place have no direction: they part vertically, the larger one downwards; of equal ones neither knows
// where to go. Half heights 1 and ½ overlap by 1.5.
TEST(FindContacts, CoincidentBoxesPartVertically) {
  const BoxDef big = box(1, {2, 2, 2}, {0, 0, 5}), small = box(2, {1, 1, 1}, {0, 0, 5});
  const World world = colliding(big, small);
  ASSERT_EQ(world.scratch().contacts.size(), 1U);
  EXPECT_EQ(world.scratch().contacts.normal[0], Vec3(0, 0, 1));
  EXPECT_NEAR(world.scratch().contacts.depth[0], 1.5, 1e-10);
  const World equal = colliding(cube(1, {0, 0, 5}), cube(2, {0, 0, 5}));
  EXPECT_EQ(equal.scratch().contacts.size(), 0U);
}

// "Vertically" is along gravity. Along (0.6, 0, 0.8) the cubes reach 0.7 · 2 and 0.7 · 1. Without gravity it is z.
TEST(FindContacts, CoincidentBoxesPartAlongGravity) {
  const BoxDef big = box(1, {2, 2, 2}, {0, 0, 5}), small = box(2, {1, 1, 1}, {0, 0, 5});
  const World aslant = colliding(big, small, 0, Vec3(-0.6, 0, -0.8) * 10);
  ASSERT_EQ(aslant.scratch().contacts.size(), 1U);
  expect_near(aslant.scratch().contacts.normal[0], {0.6, 0, 0.8});
  EXPECT_NEAR(aslant.scratch().contacts.depth[0], 1.4 + 0.7, 1e-10);
  const World upwards = colliding(big, small, 0, {0, 0, 10});
  EXPECT_EQ(upwards.scratch().contacts.normal[0], Vec3(0, 0, -1));
}

}  // namespace
}  // namespace tumble::test
