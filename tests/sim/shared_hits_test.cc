// Bodies that touch something else while they are hit bounce as their law of restitution says.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "src/collide/box_pair.h"
#include "tests/support/sim_scenes.h"
#include "tumble/sim/rotation.h"
#include "tumble/sim/world_state.h"

namespace tumble::test {
namespace {

using sim::SceneDef;
using sim::Vec3;
using sim::World;

constexpr double kDt = 1.0 / 60;
constexpr double kRestitution = 0.5;
constexpr double kOffsets[] = {0, 0.02, 0.05, 0.07, 0.1, 0.13, 0.16};  // m; the hit comes early or late in a step
constexpr int kSubsteps[] = {1, 2, 4, 8};

SceneDef floor_of(int substeps, double friction, double restitution = kRestitution) {
  SceneDef scene = on_ground();
  scene.world.method = sim::Method::kLayered;
  scene.world.dt = kDt;
  scene.world.substeps = static_cast<std::uint32_t>(substeps);
  scene.world.ground_material = {.friction = friction, .friction_dynamic = friction, .restitution = restitution};
  return scene;
}

void add(SceneDef& scene, const Vec3& size, const Vec3& position, const Vec3& velocity, bool is_static = false) {
  sim::BoxDef body = box(static_cast<sim::BodyId>(scene.boxes.size() + 1), size, position);
  body.velocity = velocity;
  body.mass = 1;
  body.is_static = is_static;
  body.material = scene.world.ground_material;
  scene.boxes.push_back(body);
}

std::string at(int substeps, double offset) {
  return std::to_string(substeps) + " substeps, " + std::to_string(offset) + " m";
}

TEST(SharedHits, ACrateThatSlidesBouncesOffAWall) {
  for (const int substeps : kSubsteps) {
    for (const double offset : kOffsets) {
      SceneDef scene = floor_of(substeps, 0);
      add(scene, {1, 1, 1}, {0, 0, 0.5}, {10, 0, 0});
      add(scene, {1, 1, 1}, {3 + offset, 0, 0.5}, {0, 0, 0}, true);
      EXPECT_NEAR(after_steps(scene, 30).bodies().velocity[0].x(), -5, 0.001) << at(substeps, offset);
    }
  }
}

// Friction of the floor brakes it on its way, 0.3 g. What friction takes at the wall is little, since nothing slips
// there.
TEST(SharedHits, FrictionOfTheFloorTakesNoPartOfTheBounce) {
  constexpr double kFriction = 0.3, kGravity = 9.81;
  for (const int substeps : kSubsteps) {
    for (const double offset : kOffsets) {
      SceneDef scene = floor_of(substeps, kFriction);
      add(scene, {1, 1, 1}, {0, 0, 0.5}, {10, 0, 0});
      add(scene, {1, 1, 1}, {3 + offset, 0, 0.5}, {0, 0, 0}, true);
      const double hit = std::sqrt(100 - 2 * kFriction * kGravity * (2 + offset));
      const double left = kRestitution * hit - kFriction * kGravity * (1 - (10 - hit) / (kFriction * kGravity));
      EXPECT_NEAR(after_steps(scene, 60).bodies().velocity[0].x(), -left, 0.06) << at(substeps, offset);
    }
  }
}

// Walls around a square whose sides are `width` m.
void add_walls(SceneDef& scene, double width) {
  const double place = (width + 1) / 2;
  for (const double side : {-place, place}) {
    add(scene, {1, 2 * width, 1}, {side, 0, 0.5}, {0, 0, 0}, true);
    add(scene, {2 * width, 1, 1}, {0, side, 0.5}, {0, 0, 0}, true);
  }
}

TEST(SharedHits, OnIceBetweenWallsFullRestitutionKeepsTheSpeed) {
  for (const int substeps : kSubsteps) {
    SceneDef scene = floor_of(substeps, 0, 1);
    add(scene, {1, 1, 1}, {0.1, 0, 0.5}, {10, 7, 0});
    add_walls(scene, 9.3);
    const World world = after_steps(scene, 1200);
    EXPECT_NEAR(std::abs(world.bodies().velocity[0].x()), 10, 0.001) << substeps;
    EXPECT_NEAR(std::abs(world.bodies().velocity[0].y()), 7, 0.001) << substeps;
  }
}

// They turn, so that a bounce at the speeds of the step's start would give more than the push has taken: up to 54 %.
// Contacts that share a body's mass still do.
TEST(SharedHits, CratesOnIceThatBounceFullyKeepMuchAndGainLittle) {
  for (const int substeps : kSubsteps) {
    SceneDef scene = floor_of(substeps, 0, 1);
    for (int k = 0; k < 8; ++k) {
      const double far = k < 4 ? 0 : 1;
      add(scene, {1, 1, 1}, {2.0 * (k % 4) - 3 + 0.1 * far, 3 * far - 1.5, 0.5}, {3.0 - k, 2.0 * (k % 3) - 2, 0});
    }
    add_walls(scene, 10);
    World world = made(scene);
    const double start = sim::total_energy(world.state()).kinetic;
    for (int k = 0; k < 600; ++k) advance(world);
    EXPECT_LT(sim::total_energy(world.state()).kinetic, 1.06 * start) << substeps;
    EXPECT_GT(sim::total_energy(world.state()).kinetic, 0.75 * start) << substeps;
  }
}

TEST(SharedHits, ACrateThatSlidesIntoACornerComesBack) {
  for (const int substeps : kSubsteps) {
    for (const double offset : kOffsets) {
      for (const double walls : {0.0, 1e4, 1e8}) {  // kg; 0: they are static
        SceneDef scene = floor_of(substeps, 0);
        add(scene, {1, 1, 1}, {0, 0, 0.5}, {5, 5, 0});
        add(scene, {1, 8, 1}, {2 + offset, 0, 0.5}, {0, 0, 0}, walls == 0);
        add(scene, {8, 1, 1}, {0, 2 + offset, 0.5}, {0, 0, 0}, walls == 0);
        if (walls > 0) scene.boxes[1].mass = scene.boxes[2].mass = walls;
        const World world = after_steps(scene, 40);
        EXPECT_NEAR(world.bodies().velocity[0].x(), -2.5, 0.02) << walls << " kg, " << at(substeps, offset);
        EXPECT_NEAR(world.bodies().velocity[0].y(), -2.5, 0.02) << walls << " kg, " << at(substeps, offset);
      }
    }
  }
}

// The two are hit in their middle, so all move along x: m v = m v₁ + 2 m v₂, v₂ − v₁ = e v.
TEST(SharedHits, AWideBoxThatHitsTwoStops) {
  for (const int substeps : kSubsteps) {
    for (const double offset : kOffsets) {
      SceneDef scene = floor_of(substeps, 0);
      add(scene, {1, 3, 1}, {0, 0, 0.5}, {10, 0, 0});
      add(scene, {1, 1, 1}, {2 + offset, 1, 0.5}, {0, 0, 0});
      add(scene, {1, 1, 1}, {2 + offset, -1, 0.5}, {0, 0, 0});
      const World world = after_steps(scene, 24);
      EXPECT_NEAR(world.bodies().velocity[0].x(), 0, 0.03) << at(substeps, offset);
      EXPECT_NEAR(world.bodies().velocity[1].x(), 5, 0.03) << at(substeps, offset);
      EXPECT_EQ(world.bodies().velocity[1].x(), world.bodies().velocity[2].x()) << at(substeps, offset);
    }
  }
}

// The deepest overlap of two bodies, m.
double deepest(const sim::Bodies& bodies) {
  const auto frame = [&](std::size_t i) {
    return sim::BoxFrame{bodies.position[i], sim::axes_of(bodies.orientation[i]), bodies.half_extent[i]};
  };
  double deepest = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t k = i + 1; k < bodies.size(); ++k) {
      deepest = std::max(deepest, -sim::BoxPair(frame(i), frame(k)).best(sim::kFaces | sim::kEdges).separation);
    }
  }
  return deepest;
}

TEST(SharedHits, WhatHitsAHeapDrivesNoBoxIntoAnother) {
  for (const int substeps : {2, 4, 8}) {
    SceneDef scene = floor_of(substeps, 0.4);
    scene.world.ground_material.restitution = 0;
    for (const double z : {0.5, 1.5, 2.5}) {
      for (const double y : {0, 1, 2}) {
        for (const double x : {-1.5, -0.5, 0.5, 1.5}) add(scene, {1, 1, 1}, {x, y, z}, {0, 0, 0});
      }
    }
    add(scene, {1, 1, 1}, {0, -8, 1.5}, {0, 30, 0});
    scene.boxes.back().mass = 5;
    World world = made(scene);
    for (int k = 0; k < 40; ++k) {
      advance(world);
      EXPECT_LT(deepest(world.bodies()), 0.06) << substeps << " substeps, step " << k;
    }
  }
}

// A body that falls bounces where it touches, and not above the ground because it would have touched a little later.
TEST(SharedHits, WhatFallsTouchesBeforeItBounces) {
  for (const int substeps : kSubsteps) {
    for (double height = 0.02; height < 1; height += 0.03) {
      SceneDef scene = floor_of(substeps, 0);
      add(scene, {1, 1, 1}, {0, 0, 0.5 + height}, {0, 0, 0});
      World world = made(scene);
      for (int k = 0; world.bodies().velocity[0].z() <= 0 && k < 60; ++k) advance(world);
      const double up = world.bodies().velocity[0].z(), fastest = kRestitution * std::sqrt(2 * 9.81 * height);
      EXPECT_LE(world.bodies().position[0].z() - 0.5, fastest * kDt + 0.0005) << at(substeps, height) << ", " << up;
    }
  }
}

}  // namespace
}  // namespace tumble::test
