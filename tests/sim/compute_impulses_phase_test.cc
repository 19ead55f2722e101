// The phase compute_impulses: whole worlds, in which momentum must be conserved.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "src/thesis/compute_impulses.h"
#include "src/thesis/find_contacts.h"
#include "src/thesis/find_pairs.h"
#include "src/thesis/find_planes.h"
#include "src/world/scratch.h"
#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::BoxDef;
using sim::SceneDef;
using sim::Vec3;
using sim::World;

void expect_near(const Vec3& found, const Vec3& wanted, double tolerance = 1e-12) {
  EXPECT_LT((found - wanted).cwiseAbs().maxCoeff(), tolerance)
      << "found " << found.transpose() << ", wanted " << wanted.transpose();
}

// Two boxes of 2 × 1 × 1 m and 8 kg, and 1 m and 1 kg, overlapping off centre, flying and turning.
World crash() {
  SceneDef scene = empty_space();
  scene.boxes = {cube(3, {0, 0, 0}), cube(8, {1.3, 0.6, 0.4})};
  scene.boxes[0].size = {2, 1, 1};
  scene.boxes[0].mass = 8;
  scene.boxes[0].velocity = {2, 0.5, -1};
  scene.boxes[0].spin = {0.5, -1, 2};
  scene.boxes[1].orientation = {0.9, 0.2, -0.1, 0.3};
  scene.boxes[1].velocity = {-3, 1, 0};
  scene.boxes[1].spin = {1, 2, -1};
  for (BoxDef& b : scene.boxes) b.material = {0.8, 0.5, 0.7};
  World world = made(scene);
  EXPECT_TRUE(test::run_phase(sim::find_pairs, world, 0).ok());
  EXPECT_TRUE(test::run_phase(sim::find_planes, world, 0).ok());
  EXPECT_TRUE(test::run_phase(sim::find_contacts, world, 0).ok());
  EXPECT_TRUE(test::run_phase(sim::compute_impulses, world, 0).ok());
  EXPECT_EQ(world.scratch().contacts.size(), 1U);
  return world;
}

// What one body gains the other loses. Gains lie on the velocity grid (2⁻³⁸), so 9 kg of them are off by 1e-11 at most;
// about the origin L = x × m v + R I Rᵀ w.
TEST(ComputeImpulses, MomentumAndAngularMomentumAreConserved) {
  const World world = crash();
  Vec3 momentum = Vec3::Zero(), angular = Vec3::Zero();
  double size = 0;
  for (sim::BodyIndex i = 0; i < 2; ++i) {
    const sim::Bodies& bodies = world.bodies();
    const Vec3 p = world.scratch().gains[i].velocity * bodies.mass[i];
    const sim::Axes axes = axes_of(bodies.orientation[i]);
    const Vec3 spin_B = to_body(axes, world.scratch().gains[i].spin);
    momentum += p;
    angular += bodies.position[i].cross(p) + to_world(axes, spin_B.cwiseProduct(bodies.inertia[i]));
    size += p.norm();
  }
  EXPECT_GT(size, 1) << "they did collide";
  expect_near(momentum, {0, 0, 0}, 5e-11);
  expect_near(angular, {0, 0, 0}, 5e-11);
}

TEST(ComputeImpulses, NothingIsAppliedYet) {
  const World world = crash();
  EXPECT_EQ(world.bodies().velocity[0], Vec3(2, 0.5, -1));
  EXPECT_EQ(world.bodies().spin[1], Vec3(1, 2, -1));
  EXPECT_EQ(world.scratch().touched, (std::vector<std::uint8_t>{1, 1}));
}

// A cube falls flat on the ground at 4 m/s and leaves at ε · 4; of the pair's two coefficients the larger counts.
TEST(ComputeImpulses, RestitutionDecidesHowHighACubeBounces) {
  for (const double restitution : {0.0, 0.5, 1.0}) {
    for (const bool ground_bounces : {false, true}) {
      SceneDef scene = on_ground();
      scene.world.gravity = Vec3::Zero();
      scene.world.dt = 0.125;
      scene.world.ground_material.restitution = ground_bounces ? restitution : 0;
      scene.boxes = {cube(1, {0, 0, 0.75})};
      scene.boxes[0].velocity = {0, 0, -4};
      scene.boxes[0].material.restitution = ground_bounces ? 0 : restitution;
      World world = made(scene);
      advance(world);
      EXPECT_NEAR(world.bodies().velocity.z[0], 4 * restitution, 1e-11);
      EXPECT_EQ(world.bodies().velocity.x[0], 0);
      expect_near(world.bodies().spin[0], {0, 0, 0}, 1e-11);
    }
  }
}

// A pair's friction is the geometric mean: √(0.9 · 0.1) = 0.3 between a box and the ground. Falling at 4 m/s with ε = 0
// it loses 0.3 · 4 of its 10 m/s; static coefficients must not matter at that speed.
TEST(ComputeImpulses, FrictionOfAPairIsTheGeometricMean) {
  SceneDef scene = on_ground();
  scene.world.gravity = Vec3::Zero();
  scene.world.ground_material = {0.8, 0.1, 0};
  scene.boxes = {cube(1, {0, 0, 0.5})};
  scene.boxes[0].velocity = {10, 0, -4};
  scene.boxes[0].material = {0.7, 0.9, 0};
  World world = made(scene);
  advance(world);
  EXPECT_NEAR(world.bodies().velocity.x[0], 10 - 0.3 * 4, 1e-11);
}

// The outcome of a pair does not depend on other pairs: a cube struck from both sides at once gets both impulses.
TEST(ComputeImpulses, OutcomesAreComputedBeforeAnyIsApplied) {
  SceneDef scene = empty_space();
  scene.boxes = {cube(1, {-0.95, 0.01, 0.02}), cube(2, {0, 0, 0}), cube(3, {0.95, 0.01, 0.02})};
  scene.boxes[0].velocity = {2, 0, 0};
  scene.boxes[2].velocity = {-2, 0, 0};
  for (BoxDef& b : scene.boxes) b.material = {0, 0, 0};
  World world = made(scene);
  ASSERT_TRUE(test::run_phase(sim::find_pairs, world, 0).ok());
  ASSERT_TRUE(test::run_phase(sim::find_planes, world, 0).ok());
  ASSERT_TRUE(test::run_phase(sim::find_contacts, world, 0).ok());
  ASSERT_TRUE(test::run_phase(sim::compute_impulses, world, 0).ok());
  ASSERT_EQ(world.scratch().contacts.size(), 2U);
  const Vec3 left = world.scratch().contacts.impulse[0], right = world.scratch().contacts.impulse[1];
  EXPECT_GT(left.x(), 0.5);
  EXPECT_EQ(left.x(), right.x());
  EXPECT_EQ(world.scratch().gains[1].velocity.x(), 0) << "equal and opposite";
}

}  // namespace
}  // namespace tumble::test
