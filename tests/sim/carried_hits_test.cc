// What bounces takes along what lies on it, and what is hit hands its push to what bears it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/support/sim_scenes.h"
#include "tumble/sim/world_state.h"

namespace tumble::test {
namespace {

using sim::SceneDef;
using sim::Vec3;
using sim::World;

constexpr double kFall = 5;  // m/s
constexpr int kSubsteps[] = {1, 2, 4, 8};
constexpr double kOffsets[] = {0, 0.003, 0.01, 0.03, 0.05};  // m; the hit comes early or late in a step

SceneDef floor_of(int substeps, double restitution, const Vec3& gravity = Vec3::Zero()) {
  SceneDef scene = on_ground();
  scene.world.method = sim::Method::kLayered;
  scene.world.dt = 1.0 / 60;
  scene.world.substeps = static_cast<std::uint32_t>(substeps);
  scene.world.gravity = gravity;
  scene.world.ground_material = {.friction = 0.3, .friction_dynamic = 0.3, .restitution = restitution};
  return scene;
}

void add(SceneDef& scene, double z, double velocity, double mass = 1) {
  sim::BoxDef body = box(static_cast<sim::BodyId>(scene.boxes.size() + 1), {1, 1, 1}, {0, 0, z});
  body.velocity = Vec3(0, 0, velocity);
  body.mass = mass;
  body.material = scene.world.ground_material;
  scene.boxes.push_back(body);
}

// Two cubes that fall as one.
SceneDef falling_pair(int substeps, double restitution, double offset) {
  SceneDef scene = floor_of(substeps, restitution);
  for (const double z : {2.0, 3.0}) add(scene, z + offset, -kFall);
  return scene;
}

double speed(const World& world, std::size_t body) { return world.bodies().velocity[body].z(); }

std::string at(int substeps, double restitution, double offset) {
  return std::to_string(substeps) + " substeps, e " + std::to_string(restitution) + ", " + std::to_string(offset) +
         " m";
}

// Both fall as one and meet the ground: Newton's law for the body that they are together.
TEST(CarriedHits, TwoCubesBounceAsOne) {
  for (const int substeps : kSubsteps) {
    for (const double e : {0.2, 0.5, 1.0}) {
      for (const double offset : kOffsets) {
        const World world = after_steps(falling_pair(substeps, e, offset), 22);
        for (const std::size_t body : {0U, 1U}) {
          EXPECT_NEAR(speed(world, body), e * kFall, 0.002) << at(substeps, e, offset);
        }
      }
    }
  }
}

// The push of a substep stops both, before they move on: without end_fast_push the upper one goes on by 10 to 83 mm.
TEST(CarriedHits, WhatLiesOnTopStaysOnTop) {
  for (const int substeps : kSubsteps) {
    for (const double e : {0.2, 0.5, 1.0}) {
      for (const double offset : kOffsets) {
        World world = made(falling_pair(substeps, e, offset));
        double deepest = 0;
        for (int k = 0; k < 24; ++k) {
          advance(world);
          deepest = std::max(deepest, 1 - (world.bodies().position[1].z() - world.bodies().position[0].z()));
        }
        EXPECT_LT(deepest, 0.001) << at(substeps, e, offset);
      }
    }
  }
}

TEST(CarriedHits, WhatLiesOnTopMayBeLightOrHeavy) {
  for (const int substeps : kSubsteps) {
    for (const double e : {0.5, 1.0}) {
      for (const double mass : {0.001, 0.1, 0.5, 2.0, 10.0}) {
        SceneDef scene = floor_of(substeps, e);
        add(scene, 2.013, -kFall);
        add(scene, 3.013, -kFall, mass);
        const World world = after_steps(scene, 40);
        const double short_by = mass > 2 ? 0.06 : 0.002;  // the turns end before a heavy body is stopped
        for (const std::size_t body : {0U, 1U}) {
          EXPECT_LE(speed(world, body), 1.0002 * e * kFall) << mass << ' ' << at(substeps, e, 0);
          EXPECT_GE(speed(world, body), (1 - short_by) * e * kFall) << mass << ' ' << at(substeps, e, 0);
        }
      }
    }
  }
}

// Taller columns get fewer turns (sweep_counts.cc), and lose more of their bounce.
TEST(CarriedHits, ThreeCubesBounceNearlyAsOne) {
  for (const int substeps : kSubsteps) {
    for (const double e : {0.5, 1.0}) {
      SceneDef scene = floor_of(substeps, e);
      for (const double z : {2.0, 3.0, 4.0}) add(scene, z, -kFall);
      const World world = after_steps(scene, 22);
      for (const std::size_t body : {0U, 1U, 2U})
        EXPECT_NEAR(speed(world, body), e * kFall, 0.01 * e * kFall) << substeps;
    }
  }
}

// Sliding friction is its coefficient times all that the ground pushes, whatever part of that a later turn gives.
TEST(CarriedHits, FrictionHasItsPartOfTheWholeBounce) {
  constexpr double kFriction = 0.1, kSlide = 4;
  for (const int substeps : kSubsteps) {
    for (const double e : {0.5, 1.0}) {
      SceneDef scene = floor_of(substeps, e);
      scene.world.ground_material.friction = scene.world.ground_material.friction_dynamic = kFriction;
      for (const double z : {2.0, 2.3}) {
        add(scene, z, -kFall);
        scene.boxes.back().size = Vec3(4, 4, 0.3);
        scene.boxes.back().velocity.x() = kSlide;
      }
      const World world = after_steps(scene, 24);
      double pushed = 0, rubbed = 0;  // N s
      for (const std::size_t body : {0U, 1U}) {
        pushed += speed(world, body) + kFall;
        rubbed += kSlide - world.bodies().velocity[body].x();
      }
      EXPECT_GT(pushed, 2 * (1 + 0.9 * e) * kFall) << at(substeps, e, 0);
      EXPECT_NEAR(rubbed, kFriction * pushed, 0.01 * kFriction * pushed) << at(substeps, e, 0);
    }
  }
}

// The ground behind a stack gives the push: what falls on it bounces nearly as off the ground, and the stack stays. (By
// version 17 it went on, and drove the stack into the ground at up to 4.7 m/s.)
TEST(CarriedHits, WhatFallsOnAStackBouncesAsOffTheGround) {
  for (const int substeps : kSubsteps) {
    for (const double e : {0.5, 1.0}) {
      for (const std::size_t below : {1U, 2U}) {
        SceneDef scene = floor_of(substeps, e, {0, 0, -9.81});
        for (std::size_t k = 0; k < below; ++k) add(scene, 0.5 + static_cast<double>(k), 0);
        add(scene, static_cast<double>(below) + 0.8, -kFall);
        World world = made(scene);
        double before = 0;
        while (speed(world, below) < 0 && before > -10) {
          before = speed(world, below);
          advance(world);
        }
        const double part = speed(world, below) / (-before * e);  // gravity acts before the hit and after it
        EXPECT_GT(part, 0.8) << below << " below, " << at(substeps, e, 0);
        EXPECT_LT(part, 1.01) << below << " below, " << at(substeps, e, 0);
        for (std::size_t k = 0; k < below; ++k) {
          EXPECT_GT(speed(world, k), -0.03)
              << "driven into what bears it, " << below << " below, " << at(substeps, e, 0);
        }
      }
    }
  }
}

struct Fall {
  double deepest = 0, up = 0;  // m, m/s
};
Fall fall_on_a_cube(int substeps, double e, double mass, double height) {
  SceneDef scene = floor_of(substeps, e, {0, 0, -9.81});
  add(scene, 0.5, 0);
  add(scene, 1.5 + height, -kFall, mass);
  World world = made(scene);
  Fall fall;
  for (int k = 0; k < 12; ++k) {
    advance(world);
    const double lower = world.bodies().position[0].z(), upper = world.bodies().position[1].z();
    fall.deepest = std::max({fall.deepest, 1 - (upper - lower), 0.5 - lower});
    fall.up = std::max(fall.up, speed(world, 1));
  }
  return fall;
}

// What falls on one body that lies is stopped before bodies move, up to 10 mm in a step of 1/60 s: swept once, it went
// 11 to 52 mm into it.
TEST(CarriedHits, WhatFallsOnABodyStaysOnTop) {
  for (const int substeps : kSubsteps) {
    for (const double e : {0.0, 0.5}) {
      for (const double mass : {1.0, 10.0, 1000.0}) {
        for (const double height : {0.1, 0.13, 0.15, 0.2, 0.25, 0.4}) {
          const Fall fall = fall_on_a_cube(substeps, e, mass, height);
          EXPECT_LT(fall.deepest, 0.01 / substeps) << mass << ' ' << at(substeps, e, height);
          EXPECT_GE(fall.up, 0.97 * e * kFall) << mass << ' ' << at(substeps, e, height);
        }
      }
    }
  }
}

// Whatever share of an impact each contact takes, all of them give back no more than was taken: bars that turn as they
// are hit, with friction.
TEST(CarriedHits, NoBounceAddsEnergy) {
  for (const int substeps : kSubsteps) {
    for (const double degrees : {5.0, 15.0, 30.0}) {
      SceneDef scene = floor_of(substeps, 1);
      const double cosine = std::cos(degrees * 3.14159265358979 / 180), sine = std::sqrt(1 - cosine * cosine);
      for (int k = 0; k < 3; ++k) {
        add(scene, 2.5 + 0.3 * k, -kFall, k == 1 ? 3 : 1);
        sim::BoxDef& bar = scene.boxes.back();
        bar.size = Vec3(2, 0.3, 0.3);
        bar.position = Vec3(-sine * 0.3 * k, 0, 2.5 + cosine * 0.3 * k);
        bar.orientation = turn({0, 1, 0}, cosine, sine);
        bar.velocity = Vec3(3, 0, -kFall);
      }
      World world = made(scene);
      const double before = sim::total_energy(world.state()).kinetic;
      for (int k = 0; k < 60; ++k) {
        advance(world);
        EXPECT_LE(sim::total_energy(world.state()).kinetic, before * 1.0001) << degrees << " degrees, " << substeps;
      }
    }
  }
}

// A column that lands without a bounce is not solved to the end; that others bounce meanwhile gives it no visit more.
TEST(CarriedHits, ABounceElsewhereMovesNoBit) {
  for (const int substeps : kSubsteps) {
    const auto column = [&](bool elsewhere) {
      SceneDef scene = floor_of(substeps, 0, {0, 0, -9.81});
      for (int k = 0; k < 8; ++k) add(scene, 1.7 + k, -kFall);
      for (int k = 0; elsewhere && k < 3; ++k) {
        add(scene, 1.7 + k, -kFall, 1 + k);
        scene.boxes.back().position.x() = 40;
        scene.boxes.back().material.restitution = 0.7;
      }
      return after_steps(scene, 40);
    };
    const World alone = column(false), with = column(true);
    for (std::size_t body = 0; body < 8; ++body) {
      EXPECT_EQ(Vec3(alone.bodies().position[body]), Vec3(with.bodies().position[body])) << substeps;
      EXPECT_EQ(Vec3(alone.bodies().velocity[body]), Vec3(with.bodies().velocity[body])) << substeps;
    }
  }
}

}  // namespace
}  // namespace tumble::test
