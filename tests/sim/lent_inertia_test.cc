// Light bodies under heavy ones, method layered, against mechanics: the inertia that the solver lends a light body so
// that a stack stands shows in no motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/support/sim_scenes.h"
#include "tumble/sim/world_state.h"

namespace tumble::test {
namespace {

using sim::SceneDef;
using sim::Vec3;
using sim::World;

constexpr double kGravity = 9.81;

sim::BoxDef crate(sim::BodyId id, double mass, const Vec3& size, const Vec3& position, double speed) {
  sim::BoxDef out = box(id, size, position);
  out.mass = mass;
  out.velocity = {speed, 0, 0};
  return out;
}

// On ground of that friction, without restitution. Friction of a pair is the geometric mean.
SceneDef scene_of(std::vector<sim::BoxDef> boxes, double on_ground_friction, double between) {
  SceneDef scene = on_ground();
  scene.world.method = sim::Method::kLayered;
  scene.world.substeps = 8;
  scene.world.freezing = false;
  sim::Material& ground = scene.world.ground_material;
  ground.friction = ground.friction_dynamic = between == 0 ? 0 : on_ground_friction * on_ground_friction / between;
  ground.restitution = 0;
  for (sim::BoxDef& body : boxes) {
    body.material.friction = body.material.friction_dynamic = between;
    body.material.restitution = 0;
  }
  scene.boxes = std::move(boxes);
  return scene;
}

World after(const SceneDef& scene, double seconds) {
  World world = made(scene);
  for (int k = 0; k < std::lround(seconds / scene.world.dt); ++k) advance(world);
  return world;
}

/// Masses of a lower and an upper body, the upper one 2 to 1000 times as heavy, and a speed.
struct Pair {
  double lower, upper, speed;
};
Pair any_pair(Random& random) {
  const double lower = random.uniform(0.1, 10);
  return {lower, lower * std::pow(10, random.uniform(0.3, 3)), random.uniform(0.2, 3)};
}

TEST(LentInertia, ACrateThatLandsOnAPlankOnIceKeepsItsMomentum) {
  Random random(1);
  for (int k = 0; k < 40; ++k) {
    const Pair p = any_pair(random);
    const World world = after(scene_of({crate(1, p.lower, {20, 4, 0.5}, {0, 0, 0.25}, 0),
                                        crate(2, p.upper, {1, 1, 0.5}, {0, 0, 0.75}, p.speed)},
                                       0, 0.5),
                              3);
    const double together = p.upper * p.speed / (p.upper + p.lower);
    for (sim::BodyIndex i : {0U, 1U}) {
      EXPECT_NEAR(world.state().bodies.velocity[i].x(), together, 1e-6 * p.speed) << k << ", body " << i;
    }
  }
}

TEST(LentInertia, AHeavyCrateOnALightOneSlidesAsCoulombSays) {
  Random random(2);
  for (int k = 0; k < 40; ++k) {
    const Pair p = any_pair(random);
    const double friction = random.uniform(0.1, 0.6), way = p.speed * p.speed / (2 * friction * kGravity);
    const SceneDef scene = scene_of(
        {crate(1, p.lower, {2, 2, 0.5}, {0, 0, 0.25}, p.speed), crate(2, p.upper, {2, 2, 0.5}, {0, 0, 0.75}, p.speed)},
        friction, 1);
    const World world = after(scene, 1 + p.speed / (friction * kGravity));
    const double substep_s = scene.world.dt / scene.world.substeps;
    EXPECT_NEAR(world.state().bodies.position[0].x(), way, 0.01 * way + p.speed * substep_s + 0.001)
        << k << ": " << p.lower << " " << p.upper / p.lower << " v " << p.speed << " mu " << friction;
    EXPECT_NEAR(world.state().bodies.position[1].x(), way, 0.01 * way + p.speed * substep_s + 0.001)
        << k << ": " << p.lower << " " << p.upper / p.lower << " v " << p.speed << " mu " << friction;
  }
}

TEST(LentInertia, BodiesThatTouchFallTogether) {
  Random random(3);
  for (int k = 0; k < 40; ++k) {
    const Pair p = any_pair(random);
    const World world = after(
        scene_of({crate(1, p.lower, {1, 1, 0.25}, {0, 0, 5.125}, 0), crate(2, p.upper, {1, 1, 1}, {0.125, 0, 5.75}, 0)},
                 0.5, 0.5),
        0.5);
    for (sim::BodyIndex i : {0U, 1U}) {
      EXPECT_NEAR(world.state().bodies.velocity[i].z(), -kGravity * 0.5, 1e-6) << k << ", body " << i;
      EXPECT_LT(sim::length(world.state().bodies.spin[i]), 1e-6) << k << ", body " << i;
    }
  }
}

// The plank turns about the block's edge, with the crate: the angular acceleration is torque over moment of inertia.
TEST(LentInertia, APlankTopplesAsFastAsItsCratePulls) {
  SceneDef scene = scene_of({crate(1, 1000, {2, 2, 2}, {0, 0, 1}, 0), crate(2, 1, {4, 1, 0.125}, {1.5, 0, 2.0625}, 0),
                             crate(3, 10, {0.5, 0.5, 0.5}, {3, 0, 2.375}, 0)},
                            1, 1);
  scene.boxes[0].is_static = true;
  const World world = after(scene, 0.2);
  const double moment = (16 + 0.125 * 0.125) / 12 + (0.25 + 0.0625 * 0.0625) + 10 * (0.25 / 6 + 4 + 0.375 * 0.375);
  const double pull = kGravity * (1 * 0.5 + 10 * 2), spin = pull / moment * 0.2;
  EXPECT_NEAR(world.state().bodies.velocity[2].z(), -2 * spin, 0.05 * 2 * spin);
}

// A plate lies across a thin wall, with a crate beside the wall: it tips about the wall's edge, however the whole lies
// against the axes of the world.
TEST(LentInertia, APlateOnAWallTipsAlikeAtAnyAngle) {
  const double moment = (16 + 0.1 * 0.1) / 12 + 2 * 0.05 * 0.05 + 10 * (0.4 * 0.4 / 6 + 0.25 * 0.25 + 0.3 * 0.3);
  const double spin = kGravity * (10 * 0.25 - 1 * 0.05) / moment * 0.1;
  for (int k = 0; k < 16; ++k) {
    const double half_turn = k * 0.125, c = std::cos(2 * half_turn), s = std::sin(2 * half_turn);
    SceneDef scene = scene_of({crate(1, 1000, {4, 0.1, 1}, {0, 0, 1.5}, 0), crate(2, 1, {4, 4, 0.1}, {0, 0, 2.05}, 0),
                               crate(3, 10, {0.4, 0.4, 0.4}, {-0.3 * s, 0.3 * c, 2.3}, 0)},
                              2, 2);
    scene.boxes[0].is_static = true;
    for (sim::BoxDef& body : scene.boxes) body.orientation = {std::cos(half_turn), 0, 0, std::sin(half_turn)};
    const World world = after(scene, 0.1);
    EXPECT_NEAR(sim::length(world.state().bodies.spin[1]), spin, 0.08 * spin) << "half turn " << half_turn;
  }
}

// Pushed down at 0.1 m/s a step, a light body presses with its own mass and not with what it is lent.
TEST(LentInertia, PushesOnALightBodyUnderAHeavyOneWeighWhatTheyAre) {
  Random random(4);
  for (int k = 0; k < 20; ++k) {
    const Pair p = any_pair(random);
    const double friction = random.uniform(0.1, 0.6), push = 0.1 * p.lower;
    const SceneDef scene = scene_of(
        {crate(1, p.lower, {2, 2, 0.5}, {0, 0, 0.25}, p.speed), crate(2, p.upper, {2, 2, 0.5}, {0, 0, 0.75}, p.speed)},
        friction, 1);
    World world = made(scene);
    const double load = (p.lower + p.upper) * kGravity + push / scene.world.dt;
    const double slows = friction * load / (p.lower + p.upper), way = p.speed * p.speed / (2 * slows);
    for (int step = 0; step < std::lround((0.2 + p.speed / slows) / scene.world.dt); ++step) {
      give(world, sim::Push{1, {0, 0, -push}});
      advance(world);
    }
    const double substep_s = scene.world.dt / scene.world.substeps;
    EXPECT_NEAR(world.state().bodies.position[0].x(), way, 0.02 * way + p.speed * substep_s + 0.001)
        << k << ": " << p.lower << " " << p.upper / p.lower << " v " << p.speed << " mu " << friction;
  }
}

// A light body between a heavy one and the ground is hit from the side: it takes the blow alone, as from under a cloth.
TEST(LentInertia, ALightPlankIsKnockedOutFromUnderAHeavyCrate) {
  const World world =
      after(scene_of({crate(1, 1, {2, 2, 0.5}, {0, 0, 0.25}, 0), crate(2, 100, {0.5, 0.5, 0.5}, {0, 0, 0.75}, 0),
                      crate(3, 1, {0.5, 0.5, 0.5}, {-1.5, 0, 0.25}, 20)},
                     0.01, 0.01),
            0.05);
  // Half of 20 m/s, less what friction takes from 2 kg in the 0.0375 s since: 0.01 · 9.81 m/s² · (100 + 101 + 1) kg.
  EXPECT_NEAR(world.state().bodies.velocity[0].x(), 10 - 9.9 * 0.0375, 0.05);
  EXPECT_NEAR(world.state().bodies.velocity[1].x(), 0.01 * kGravity * 0.0375, 0.001);
}

// How far the light box is pressed into the ground, m, and the heavy one into it.
double crushed(const SceneDef& scene) {
  World world = made(scene);
  double most = 0;
  for (int step = 0; step < 90; ++step) {
    advance(world);
    const auto& places = world.state().bodies.position;
    most = std::max({most, 0.5 - places[0].z(), 1 - (places[1].z() - places[0].z())});
  }
  return most;
}
SceneDef heavy_above_light(double heavy, double fall) {
  return scene_of({crate(1, 1, {1, 1, 1}, {0, 0, 0.5}, 0), crate(2, heavy, {1, 1, 1}, {0, 0, 1.5 + fall}, 0)}, 1, 1);
}

// Whenever in a step the heavy box meets it: the speed that a hit leaves the light box points into the ground on which
// it stands, so the box bears what fell on it in the next step too.
TEST(LentInertia, AHeavyBoxCrushesNoLightOneWhateverItsFall) {
  for (const double heavy : {300.0, 1e4, 1e9}) {
    for (int k = 0; k < 40; ++k) {
      EXPECT_LT(crushed(heavy_above_light(heavy, 0.3 + 0.05 * k)), 0.001) << heavy << " kg, fall " << k;
    }
  }
}

// One that began the session asleep has felt no impulse yet, and bears the hit all the same.
TEST(LentInertia, AHeavyBoxCrushesNoLightOneThatBeganAsleep) {
  for (const double heavy : {10.0, 100.0, 3000.0}) {
    for (int k = 0; k < 40; ++k) {
      SceneDef scene = heavy_above_light(heavy, 0.3 + 0.05 * k);
      scene.world.freezing = scene.boxes[0].frozen = true;
      for (sim::BoxDef& body : scene.boxes) body.material.restitution = 0.2;
      EXPECT_LT(crushed(scene), 0.008) << heavy << " kg, fall " << k;
    }
  }
}

TEST(LentInertia, TowersStandWhenATonneDropsOnThem) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    std::vector<sim::BoxDef> boxes;
    Random random(seed);
    for (sim::BodyId id = 1; id <= 5; ++id) {
      boxes.push_back(crate(id, 1, {1, 1, 1},
                            {random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01), static_cast<double>(id) - 0.5},
                            0));
    }
    boxes.push_back(crate(100, 1000, {1, 1, 1}, {0.05, 0.02, random.uniform(6, 9)}, 0));
    SceneDef scene = scene_of(boxes, 0.4, 0.4);
    for (sim::BoxDef& body : scene.boxes) body.material.restitution = 0.2;
    const World world = after(scene, 4);
    for (sim::BodyIndex i = 0; i < 6; ++i) {
      const Vec3 wanted(boxes[i].position.x(), boxes[i].position.y(), i + 0.5);
      EXPECT_LT(sim::length(Vec3(world.state().bodies.position[i] - wanted)), 0.15)
          << "seed " << seed << ", body " << i;
    }
  }
}

}  // namespace
}  // namespace tumble::test
