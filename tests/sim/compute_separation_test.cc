// Thesis III.C.1 and III.E: displacements, how they merge (Figs. 8 and 9), and the energy they would pump in.
#include "src/thesis/compute_separation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "src/math/lift_cost.h"
#include "src/thesis/apply_outcomes.h"
#include "src/world/scratch.h"
#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::BodyIndex;
using sim::BoxDef;
using sim::kGround;
using sim::LiftCost;
using sim::SceneDef;
using sim::Vec3;
using sim::World;

constexpr double kGridStep = 0x1p-36;

void expect_near(const Vec3& found, const Vec3& wanted, double tolerance = kGridStep) {
  EXPECT_LE((found - wanted).cwiseAbs().maxCoeff(), tolerance)
      << "found " << found.transpose() << ", wanted " << wanted.transpose();
}

struct Overlap {
  BodyIndex a, b;
  Vec3 normal;  // from a to b
  double depth;
};

// The displacements that these collisions give, wherever the bodies are.
World separated(const std::vector<BoxDef>& boxes, const std::vector<Overlap>& overlaps) {
  SceneDef scene = empty_space();
  scene.boxes = boxes;
  World world = made(scene);
  sim::Contacts& contacts = world.mutable_scratch().contacts;
  for (const Overlap& o : overlaps) {
    contacts.a.push_back(o.a);
    contacts.b.push_back(o.b);
    contacts.planes.push_back(1);
    contacts.normal.push_back(o.normal);
    contacts.depth.push_back(o.depth);
  }
  EXPECT_TRUE(test::run_phase(sim::compute_separation, world, 0).ok());
  return world;
}

std::vector<BoxDef> masses(const std::vector<double>& kg) {
  std::vector<BoxDef> boxes;
  for (const double mass : kg) {
    boxes.push_back(cube(boxes.size() + 1, {10.0 * static_cast<double>(boxes.size()), 0, 0}));
    boxes.back().mass = mass;
  }
  return boxes;
}

// 1 kg and 3 kg, 0.04 m deep: away from each other by 3/4 and 1/4 of it, so that the centre of mass stays.
TEST(ComputeSeparation, SharesVaryInverselyWithMass) {
  const World world = separated(masses({1, 3}), {{0, 1, {0.6, 0, 0.8}, 0.04}});
  expect_near(world.scratch().displacement[0], Vec3(0.6, 0, 0.8) * -0.03);
  expect_near(world.scratch().displacement[1], Vec3(0.6, 0, 0.8) * 0.01);
}

TEST(ComputeSeparation, GroundDoesNotGiveWay) {
  const World world = separated(masses({5}), {{0, kGround, {0, 0, -1}, 0.125}});
  EXPECT_EQ(world.scratch().displacement[0], Vec3(0, 0, 0.125));
}

TEST(ComputeSeparation, FrozenAndStaticBodiesDoNotGiveWay) {
  for (const bool frozen : {false, true}) {
    std::vector<BoxDef> boxes = masses({1, 1});
    boxes[1].frozen = frozen;
    boxes[1].is_static = !frozen;
    const World world = separated(boxes, {{0, 1, {1, 0, 0}, 0.25}});
    EXPECT_EQ(world.scratch().displacement[0], Vec3(-0.25, 0, 0));
    EXPECT_EQ(world.scratch().displacement[1], Vec3(0, 0, 0));
  }
}

// Fig. 8: two overlaps of 0.125 and 0.0625 on one side. The sum (a) would be too much, the mean (b) too little.
TEST(ComputeSeparation, SameDirectionTakesTheLarger) {
  const std::vector<BoxDef> boxes = masses({1});
  const Overlap more = {0, kGround, {0, 0, -1}, 0.125}, less = {0, kGround, {0, 0, -1}, 0.0625};
  for (const auto& order : {std::vector{more, less}, std::vector{less, more}}) {
    EXPECT_EQ(separated(boxes, order).scratch().displacement[0], Vec3(0, 0, 0.125));
  }
}

// Fig. 9 among walls: what is perpendicular contributes, what is opposite is shared out: x 0.25 and 0.125 one way and
// 0.0625 the other, z 0.5. The sum of squares is least at (0.25 + 0.125 − 0.0625) / 3 along x. In any order.
TEST(ComputeSeparation, PerpendicularContributesAndOppositeIsSharedOut) {
  std::vector<Overlap> overlaps = {{0, kGround, {-1, 0, 0}, 0.25},
                                   {0, kGround, {-1, 0, 0}, 0.125},
                                   {0, kGround, {1, 0, 0}, 0.0625},
                                   {0, kGround, {0, 0, -1}, 0.5}};
  Random random(2);
  for (int trial = 0; trial < 10; ++trial) {
    shuffle(overlaps, random);
    expect_near(separated(masses({1}), overlaps).scratch().displacement[0], Vec3(0.3125 / 3, 0, 0.5));
  }
}

// As in the thesis, where bodies give way: 0.25 and 0.1875 one way are half of 0.5 and 0.375, and the opposite 0.0625
// is added. The frozen body would share it out.
TEST(ComputeSeparation, OppositeIsAddedWhereBodiesGiveWay) {
  const std::vector<Overlap> overlaps = {
      {0, 1, {0, 0, -1}, 0.5}, {0, 2, {0, 0, -1}, 0.375}, {0, 3, {0, 0, 1}, 0.125}, {0, 4, {-1, 0, 0}, 0.125}};
  std::vector<BoxDef> boxes = masses({1, 1, 1, 1, 1});
  expect_near(separated(boxes, overlaps).scratch().displacement[0], Vec3(0.0625, 0, 0.25 - 0.0625));
  for (std::size_t k = 1; k < boxes.size(); ++k) boxes[k].frozen = true;
  expect_near(separated(boxes, overlaps).scratch().displacement[0], Vec3(0.125, 0, (0.5 + 0.375 - 0.125) / 3));
}

// Lifted by 0.05 m under 10 m/s²: ½ J/kg. Falling at 2 m/s there are 2 J/kg of vertical energy; √3 m/s is left of it.
TEST(PayForLift, TakesTheExactEnergyOutOfTheVerticalSpeed) {
  const LiftCost cost = sim::pay_for_lift({3, -1, -2}, {0.1, 0.2, 0.05}, {0, 0, -10}, {0, 0, 1});
  expect_near(cost.velocity, {3, -1, -std::sqrt(3.0)}, 1e-11);
  EXPECT_NEAR(cost.removed, 0.5, 1e-11);
  const LiftCost rising = sim::pay_for_lift({3, -1, 2}, {0, 0, 0.05}, {0, 0, -10}, {0, 0, 1});
  expect_near(rising.velocity, {3, -1, std::sqrt(3.0)}, 1e-11);
}

// 0.3 m cost 3 J/kg; there are only 2, and the horizontal 5 J/kg are not touched.
TEST(PayForLift, TakesNoMoreThanThereIs) {
  const LiftCost cost = sim::pay_for_lift({3, -1, -2}, {0, 0, 0.3}, {0, 0, -10}, {0, 0, 1});
  EXPECT_EQ(cost.velocity, Vec3(3, -1, 0));
  EXPECT_NEAR(cost.removed, 2, 1e-11);
}

TEST(PayForLift, SidewaysAndDownwardsIsFree) {
  for (const Vec3& displacement : {Vec3(0.5, 0.5, 0), Vec3(0, 0, -0.5), Vec3(0, 0, 0)}) {
    const LiftCost cost = sim::pay_for_lift({3, -1, -2}, displacement, {0, 0, -10}, {0, 0, 1});
    EXPECT_EQ(cost.velocity, Vec3(3, -1, -2));
    EXPECT_EQ(cost.removed, 0);
  }
  EXPECT_EQ(sim::pay_for_lift({3, -1, -2}, {0, 0, 1}, {0, 0, 0}, {0, 0, 1}).velocity, Vec3(3, -1, -2)) << "no gravity";
}

// Up is against gravity: (0.6, 0, 0.8) here. 0.05 m up it, at 2 m/s down it, with 5 m/s across: √3 of the 2 is left.
TEST(PayForLift, VerticalIsAlongGravity) {
  const Vec3 up(0.6, 0, 0.8), across(0.8, 0, -0.6);
  const LiftCost cost = sim::pay_for_lift(up * -2 + across * 5, up * 0.05 + across * 0.3, up * -10, up);
  expect_near(cost.velocity, up * -std::sqrt(3.0) + across * 5, 1e-11);
  EXPECT_NEAR(cost.removed, 0.5, 1e-11);
}

// A cube of 4 kg that has sunk 0.05 m into smooth ground, falling at 2 m/s with ε = ½. It leaves at 1 m/s, is lifted
// 0.05 m, and 10 · 0.05 = ½ J/kg, all that 1 m/s holds, is taken out again: 2 J in all.
TEST(ApplyOutcomes, SeparationFromTheGroundPumpsNoEnergyIn) {
  SceneDef scene = on_ground();
  scene.world.gravity = {0, 0, -10};
  scene.world.dt = 1e-7;
  scene.boxes = {cube(1, {0, 0, 0.45})};
  scene.boxes[0].mass = 4;
  scene.boxes[0].velocity = {7, 0, -2};
  scene.boxes[0].material = {0, 0, 0.5};
  World world = made(scene);
  const sim::StepCounters counters = advance(world);
  EXPECT_NEAR(world.bodies().position.z[0], 0.5, 1e-6);
  EXPECT_NEAR(world.bodies().velocity.z[0], 0, 2e-3) << "√(1 − 2·10·0.05) = 0, within √ of the rounding of dt";
  EXPECT_NEAR(world.bodies().velocity.x[0], 7, 1e-11);
  EXPECT_NEAR(counters.removed, 2, 1e-5);
}

// Impulse and displacement arrive together: the displacement does not wait a step, nor does the velocity.
TEST(ApplyOutcomes, AppliesGainsAndDisplacementToMovingBodiesOnly) {
  SceneDef scene = empty_space();
  scene.boxes = masses({1, 1, 1});
  scene.boxes[1].frozen = true;
  scene.boxes[2].is_static = true;
  World world = made(scene);
  sim::Scratch& scratch = world.mutable_scratch();
  scratch.gains.assign(3, {{1, 2, 3}, {4, 5, 6}, {-0.25, 0, 0}});
  scratch.displacement.assign(3, {0.5, 0.25, 0.125});
  scratch.touched = {1, 1, 1};
  scratch.hit = {1, 1, 1};
  ASSERT_TRUE(test::run_phase(sim::apply_outcomes, world, 0).ok());
  const sim::Bodies& bodies = world.bodies();
  EXPECT_EQ(bodies.position[0], Vec3(0.25, 0.25, 0.125)) << "displaced, less the way that friction takes back";
  EXPECT_EQ(bodies.position[1], Vec3(10, 0, 0));
  EXPECT_EQ(bodies.position[2], Vec3(20, 0, 0));
  EXPECT_EQ(bodies.velocity[0], Vec3(1, 2, 3));
  EXPECT_EQ(bodies.spin[0], Vec3(4, 5, 6));
  EXPECT_EQ(bodies.velocity[1], Vec3(1, 2, 3)) << "a frozen body is tried: update_freezing decides";
  EXPECT_EQ(bodies.velocity[2], Vec3(0, 0, 0));
}

// What rests pays for a lift out of its speed along the lift, so that a crate keeps the speed at which it slides down a
// slope; what was hit pays out of its speed along gravity.
TEST(ApplyOutcomes, SlidingPaysNothingForALiftOffTheSlope) {
  for (const bool hit : {false, true}) {
    SceneDef scene = empty_space();
    scene.world.gravity = {6, 0, -8};
    scene.boxes = {cube(1, {0, 0, 0})};
    scene.boxes[0].velocity = {2, 0, 0};
    World world = made(scene);
    sim::Scratch& scratch = world.mutable_scratch();
    scratch.gains.assign(1, {});
    scratch.displacement.assign(1, {0, 0, 0.0625});
    scratch.touched = {1};
    scratch.hit = {hit ? std::uint8_t{1} : std::uint8_t{0}};
    ASSERT_TRUE(test::run_phase(sim::apply_outcomes, world, 0).ok());
    EXPECT_EQ(world.bodies().velocity[0] == Vec3(2, 0, 0), !hit);
  }
}

}  // namespace
}  // namespace tumble::test
