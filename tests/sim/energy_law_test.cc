// Bounces and friction keep to the law of energy, whatever turns.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/sim_scenes.h"
#include "tumble/sim/world_state.h"

namespace tumble::test {
namespace {

using sim::Vec3;

constexpr int kBoxes = 40;      // that bounce for a minute each
constexpr int kMinute = 3600;   // steps
constexpr int kScenes = 100;    // that start apart
constexpr int kBars = 200;      // that hit the ground in nearly one way
constexpr int kSeconds4 = 240;  // steps

double energy_of(const sim::World& world) {
  const sim::Energy energy = sim::total_energy(world.state());
  return energy.kinetic + energy.potential;
}

Vec3 random_size(Random& random, double low, double high) {
  const double x = random.uniform(low, high), y = random.uniform(low, high);
  return {x, y, random.uniform(low, high)};
}

sim::SceneDef scene_of(sim::Method method, double friction, double restitution) {
  sim::SceneDef scene = on_ground();
  scene.world.method = method;
  scene.world.freezing = false;
  scene.world.substeps = 8;
  scene.world.ground_material.friction = scene.world.ground_material.friction_dynamic = friction;
  scene.world.ground_material.restitution = restitution;
  return scene;
}

sim::SceneDef layered_scene(double friction, double restitution) {
  return scene_of(sim::Method::kLayered, friction, restitution);
}

sim::BoxDef body_of(sim::BodyId id, const Vec3& size, const Vec3& position, double friction, double restitution) {
  sim::BoxDef body = box(id, size, position);
  body.material.friction = body.material.friction_dynamic = friction;
  body.material.restitution = restitution;
  return body;
}

void expect_full_bounces_to_keep_energy(sim::Method method) {
  for (std::uint64_t seed = 0; seed < kBoxes; ++seed) {
    Random random(seed);
    sim::SceneDef scene = scene_of(method, 0, 1);
    const bool bar = seed >= kBoxes / 2 && seed % 2 == 0;
    const Vec3 size = bar             ? random_size(random, 0.05, 1.5)
                      : seed % 3 == 0 ? Vec3(1, 1, 1)
                                      : random_size(random, 0.3, 1.5);
    sim::BoxDef body = body_of(1, size, {0, 0, random.uniform(2, 4)}, 0, 1);
    body.orientation = sim::normalised(random.rotation());
    body.spin = random_vector(random, 5);
    scene.boxes = {body};
    sim::World world = made(scene);
    const double start = energy_of(world);
    double most = 0, least = 0;
    for (int k = 0; k < kMinute; ++k) {
      advance(world);
      most = std::max(most, energy_of(world) / start - 1);
      least = std::min(least, energy_of(world) / start - 1);
    }
    EXPECT_LE(most, 1e-6) << "seed " << seed;
    EXPECT_GE(least, bar ? -1e-5 : -1e-6) << "seed " << seed;
  }
}

TEST(EnergyLaw, ABoxThatBouncesFullyKeepsItsEnergyForAMinute) {
  expect_full_bounces_to_keep_energy(sim::Method::kLayered);
}

// Where a box hits the ground as it turns, its own speed often cannot pay for the lift out of the ground.
TEST(EnergyLaw, ABoxThatBouncesFullyByTheThesisKeepsItsEnergyForAMinute) {
  expect_full_bounces_to_keep_energy(sim::Method::kThesis);
}

// A spinning cube on its corner slides: friction at one point can stop no spin, and must not push along the slip.
TEST(EnergyLaw, FrictionUnderASpinningCornerOnlyTakesEnergy) {
  for (const double friction : {0.05, 0.2, 0.4, 0.8}) {
    sim::SceneDef scene = layered_scene(friction, 0);
    sim::BoxDef cube = body_of(1, Vec3::Constant(1.11), {0, 0, 0.774}, friction, 0);
    cube.orientation = sim::normalised({0.0259, -0.0867, 0.5917, 0.8011});
    cube.velocity = {-0.95, -0.57, -0.05};
    cube.spin = {0.9, 0.9, 14.8};
    scene.boxes = {cube};
    sim::World world = made(scene);
    const double start = energy_of(world);
    double before = start, gained = 0;
    for (int k = 0; k < 60; ++k) {
      advance(world);
      gained += std::max(0.0, energy_of(world) - before);
      before = energy_of(world);
    }
    EXPECT_LE(gained, 1e-4 * start) << "friction " << friction;
    EXPECT_LT(before, 0.99 * start) << "friction " << friction;
  }
}

void add_bodies(sim::SceneDef& scene, Random& random, double friction, double restitution, double speed, double spin) {
  for (sim::BodyId id = 1; id <= 6; ++id) {
    const Vec3 place(2.5 * static_cast<double>(id % 3), 2.5 * static_cast<double>(id % 2),
                     1.1 + static_cast<double>(id));
    sim::BoxDef body = body_of(id, random_size(random, 0.2, 1.2), place, friction, restitution);
    body.orientation = sim::normalised(random.rotation());
    body.velocity = random_vector(random, speed);
    body.spin = random_vector(random, spin);
    scene.boxes.push_back(body);
  }
}

// The most that a scene gains over its start, as a part of the start's energy.
double gain_of(const sim::SceneDef& scene, int steps) {
  sim::World world = made(scene);
  const double start = energy_of(world);
  double most = 0;
  for (int k = 0; k < steps; ++k) {
    advance(world);
    most = std::max(most, energy_of(world) / start - 1);
  }
  return most;
}

void expect_no_gain(std::uint32_t substeps, double bound) {
  for (std::uint64_t seed = 0; seed < kScenes; ++seed) {
    Random random(500 + seed);
    const double friction = 0.4 * static_cast<double>(seed % 3), restitution = 0.3 * static_cast<double>(seed % 4 % 3);
    sim::SceneDef scene = layered_scene(friction, restitution);
    scene.world.substeps = substeps;
    add_bodies(scene, random, friction, restitution, seed % 2 == 0 ? 2 : 10, seed % 5 == 0 ? 30 : 3);
    EXPECT_LE(gain_of(scene, kSeconds4), bound) << "seed " << seed;
  }
}

TEST(EnergyLaw, ScenesThatStartApartGainNothing) { expect_no_gain(8, 1e-3); }

TEST(EnergyLaw, ScenesWithOneSubstepGainNothing) { expect_no_gain(1, 1e-3); }

// A heavy cube drives a light one into the ground while that still parts from one of the two: what the pushes give the
// bodies by that, no bounce gives once more.
TEST(EnergyLaw, ALightCubeBetweenAHeavyOneAndTheGroundGainsNothing) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    for (const double heavy : {4.0, 10.0}) {
      Random random(seed);
      sim::SceneDef scene = layered_scene(0, 1);
      scene.world.substeps = seed % 2 == 0 ? 8 : 4;
      scene.world.gravity = Vec3::Zero();
      for (const sim::BodyId id : {1U, 2U}) {
        const Vec3 place(id == 1 ? 0 : random.uniform(-0.4, 0.4), 0, id == 1 ? 1 : 2.6);
        sim::BoxDef body = body_of(id, {1, 1, 1}, place, 0, 1);
        body.mass = id == 1 ? 1 : heavy;
        const double half = 0.5 * random.uniform(0, 1.57);
        body.orientation = turn({0, 1, 0}, std::cos(half), std::sin(half));
        body.velocity = Vec3(random.uniform(-1, 1), 0, id == 1 ? random.uniform(-4, 0) : random.uniform(-12, -5));
        scene.boxes.push_back(body);
      }
      sim::World world = made(scene);
      const double before = energy_of(world);
      double most = 0;
      for (int k = 0; k < 120; ++k) {
        advance(world);
        most = std::max(most, energy_of(world) / before - 1);
      }
      EXPECT_LT(most, 1e-6) << "seed " << seed << ", " << heavy << " kg";
    }
  }
}

// A box that lies in the ground is lifted out of it; what that adds to its energy comes out of its motion.
TEST(EnergyLaw, OverlapsPartAtTheCostOfTheMotion) {
  const Vec3 motions[][2] = {
      {{3, 0, 0}, {0, 0, 0}}, {{0, 0, 3}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 2}}, {{1, -2, 1}, {0, 0, 1}}};
  for (const auto& [velocity, spin] : motions) {
    sim::SceneDef scene = layered_scene(0, 0);
    scene.boxes = {body_of(1, {1.2, 1, 0.8}, {0, 0, 0.38}, 0, 0)};
    scene.boxes[0].velocity = velocity;
    scene.boxes[0].spin = spin;
    EXPECT_LE(gain_of(scene, 60), 1e-6) << velocity.transpose() << ", spin " << spin.transpose();
  }
}

// A bar resists a push across it far less than one along it, so friction that opposes the slip and friction that stops
// most of its energy differ.
TEST(EnergyLaw, ABarThatHitsTheGroundGainsNothing) {
  for (std::uint64_t seed = 0; seed < kBars; ++seed) {
    Random random(900 + seed);
    sim::SceneDef scene = layered_scene(0.8, 0.6);
    scene.world.dt = 1.0 / 120;
    sim::BoxDef bar = body_of(1, {0.1427, 0.0684, 1.5175}, {0, 0, 0.3229}, 0.8, 0.6);
    bar.orientation = sim::normalised({-0.11207, -0.66202, -0.03219, -0.74036});
    bar.velocity = Vec3(-3.6716, 0.2456, -4.6116) + random_vector(random, 1);
    bar.spin = Vec3(38.3132, -13.0883, 5.174) + random_vector(random, 4);
    scene.boxes = {bar};
    EXPECT_LE(gain_of(scene, 30), 1e-6) << "seed " << seed;
  }
}

}  // namespace
}  // namespace tumble::test
