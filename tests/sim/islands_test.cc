// Method layered: what happens in one island changes no bit of another, however far the sums of that one reach, however
// deep, tall, heavy, slender or fast it is. And what islands of few levels need of their own sweeps.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::BodyIndex;
using sim::SceneDef;
using sim::Vec3;
using sim::World;

constexpr double kFar = 500;  // m
constexpr sim::BodyId kFirstElsewhere = 700000;

struct Named {
  const char* name;
  SceneDef scene;
};

SceneDef layered(SceneDef scene, std::uint32_t substeps = 8) {
  scene.world.method = sim::Method::kLayered;
  scene.world.substeps = substeps;
  return scene;
}

SceneDef of_boxes(std::vector<sim::BoxDef> boxes) {
  SceneDef scene = on_ground();
  scene.boxes = std::move(boxes);
  return scene;
}

sim::BoxDef moving(sim::BoxDef box, const Vec3& velocity, const Vec3& spin = Vec3::Zero()) {
  box.velocity = velocity;
  box.spin = spin;
  return box;
}

SceneDef jittered(SceneDef scene) {
  jitter(scene, 0.01, 3);
  return scene;
}

SceneDef thrown_at_wall() {
  SceneDef scene = wall(4, 4);
  add_thrown_cube(scene);
  return scene;
}

// What needs many sweeps, wide grids or special treatment.
std::vector<Named> neighbours() {
  sim::BoxDef heavy = cube(1, {0, 0, 6});
  heavy.mass = 1e9;
  return {
      {"tower of 60", jittered(tower(60))},
      {"two deep in each other", of_boxes({cube(1, {0, 0, 0.5}), cube(2, {0, 0, 1.42})})},
      {"heavy on a pole", of_boxes({heavy, box(2, {0.05, 0.05, 3}, {0, 0, 2})})},
      {"bullet at a plate",
       of_boxes({moving(box(1, {0.05, 0.05, 0.05}, {0, 0, 0.5}), {400, 0, 2}), box(2, {0.05, 2, 2}, {3, 0, 1})})},
      {"bars in flight", of_boxes({moving(box(1, {0.05, 0.05, 2}, {0, 0, 4}), {20, 0, 0}, {0, 30, 0}),
                                   moving(box(2, {0.05, 0.05, 2}, {3, 0, 4}), {-20, 0, 0}, {30, 0, 0})})},
      {"falling plates", plates_and_bars(12, 5)},
      {"many loose boxes", pile(3)},
      {"a hundred metres long", of_boxes({box(1, {100, 1, 1}, {0, 0, 0.5}), cube(2, {30, 0, 1.5})})},
  };
}

std::vector<Named> scenes() {
  return {
      {"tower of 6", layered(jittered(tower(6)))},
      {"tower of 6, one substep", layered(jittered(tower(6)), 1)},
      {"pile", layered(jittered(pile(3)))},
      {"thrown at a wall", layered(thrown_at_wall(), 2)},
      {"grid", layered(tilted_grid(6), 1)},
      {"ramp", layered(ramp(8, 2))},
      {"sizes", layered(size_ratio())},
      {"plates and bars", layered(plates_and_bars(10, 3), 4)},
      {"tumble", layered(tumble_of_boxes(3, 8), 1)},
  };
}

SceneDef with(const SceneDef& scene, const SceneDef& neighbour) {
  SceneDef both = scene;
  for (sim::BoxDef box : neighbour.boxes) {
    box.id += kFirstElsewhere;
    box.position += Vec3(kFar, kFar, 0);
    both.boxes.push_back(box);
  }
  return both;
}

// Empty, or the first body of `alone` that `beside` moves otherwise.
std::string first_difference(const World& alone, const World& beside) {
  const sim::Bodies &a = alone.bodies(), &b = beside.bodies();
  for (BodyIndex i = 0; i < a.size(); ++i) {
    const bool same = a.id[i] == b.id[i] && a.position[i] == b.position[i] && a.velocity[i] == b.velocity[i] &&
                      a.spin[i] == b.spin[i] && a.orientation[i] == b.orientation[i] && a.frozen[i] == b.frozen[i];
    if (!same) return "body " + std::to_string(a.id[i]);
  }
  return {};
}

TEST(Islands, WhatHappensElsewhereChangesNoBit) {
  for (const Named& here : scenes()) {
    World alone = made(here.scene);
    std::vector<World> beside;
    for (const Named& there : neighbours()) beside.push_back(made(with(here.scene, there.scene)));
    for (int step = 1; step <= 60; ++step) {
      advance(alone);
      for (std::size_t k = 0; k < beside.size(); ++k) {
        advance(beside[k]);
        ASSERT_EQ(first_difference(alone, beside[k]), "")
            << here.name << " beside " << neighbours()[k].name << ", step " << step;
      }
    }
  }
}

// A column of two that lands: one sweep solves the ground's contact before the hit from above, and the column went on
// into the ground for a substep, 2 mm, and was lifted out again, which is energy from nowhere.
TEST(Islands, AColumnThatLandsIsHeldByTheGround) {
  for (int k = 0; k < 40; ++k) {
    const double height = 0.01 + 0.004 * k;
    World world = made(layered(of_boxes({cube(1, {0, 0, 0.5 + height}), cube(2, {0, 0, 1.6 + height})})));
    double lowest = 1;
    for (int step = 0; step < 60; ++step) {
      advance(world);
      lowest = std::min(lowest, world.bodies().position[0].z());
    }
    EXPECT_GT(lowest, 0.5 - 0.0012) << "from " << height << " m";
  }
}

}  // namespace
}  // namespace tumble::test
