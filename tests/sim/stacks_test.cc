// What method layered is for: stacks that stand from the first step on, whatever they are made of.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "src/layered/find/meeting_time.h"
#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::BoxFrame;
using sim::SceneDef;
using sim::Vec3;
using sim::World;

constexpr double kGravity = 9.81;

SceneDef standing(SceneDef scene, double seconds, std::uint64_t seed) {
  jitter(scene, 0.005, seed);
  scene.world.method = sim::Method::kLayered;
  scene.world.dt = 1.0 / 60;
  scene.world.substeps = 8;
  scene.world.freezing = false;
  scene.steps = static_cast<std::uint64_t>(std::lround(seconds * 60));
  return scene;
}

SceneDef tower_of(const std::vector<double>& masses) {
  SceneDef scene = tower(static_cast<std::uint32_t>(masses.size()));
  for (std::size_t i = 0; i < masses.size(); ++i) scene.boxes[i].mass = masses[i];
  return scene;
}

double height_energy(const SceneDef& scene) {
  double energy = 0;
  for (const sim::BoxDef& box : scene.boxes) {
    if (!box.is_static) energy += box.mass * kGravity * (box.position.z() - 0.5 * box.size.minCoeff());
  }
  return energy;
}

struct Outcome {
  double drift = 0;  // m, sideways, of the box that went farthest
  double sink = 0;   // m, of the box that sank most
  double gain = 0;   // of energy over its running minimum, part of the height energy at the start
};

Outcome run(const SceneDef& scene) {
  World world = made(scene);
  const sim::Energy start = sim::total_energy(world.state());
  double lowest = start.kinetic + start.potential;
  Outcome outcome;
  while (world.state().step < scene.steps) {
    const sim::StepCounters counters = advance(world);
    const double energy = counters.kinetic + counters.potential;
    lowest = std::min(lowest, energy);
    outcome.gain = std::max(outcome.gain, (energy - lowest) / height_energy(scene));
  }
  for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
    const Vec3 way = world.bodies().position[i] - scene.boxes[i].position;
    outcome.drift = std::max(outcome.drift, std::sqrt(way.x() * way.x() + way.y() * way.y()));
    outcome.sink = std::max(outcome.sink, -way.z());
  }
  return outcome;
}

void expect_to_stand(const std::string& what, const SceneDef& scene) {
  const Outcome outcome = run(scene);
  EXPECT_LT(outcome.drift, 1e-5) << what;
  EXPECT_LT(outcome.sink, 1e-5) << what;
  EXPECT_LT(outcome.gain, 1e-8) << what;
}

TEST(Stacks, TowersStandWhereTheyWerePut) {
  for (const std::uint32_t count : {5U, 20U, 40U}) {
    expect_to_stand("tower of " + std::to_string(count), standing(tower(count), 10, count));
  }
}

TEST(Stacks, AThousandToOneInEveryOrder) {
  expect_to_stand("light first", standing(tower_of({1, 1000, 1, 1000, 1, 1000, 1, 1000, 1, 1000}), 10, 1));
  expect_to_stand("heavy first", standing(tower_of({1000, 1, 1000, 1, 1000, 1, 1000, 1, 1000, 1}), 10, 2));
  expect_to_stand("heavy on nine light ones", standing(tower_of({1, 1, 1, 1, 1, 1, 1, 1, 1, 1000}), 10, 3));
  expect_to_stand("nine light ones on heavy", standing(tower_of({1000, 1, 1, 1, 1, 1, 1, 1, 1, 1}), 10, 4));
  expect_to_stand("heavier by and by", standing(tower_of({1, 2, 5, 10, 22, 46, 100, 215, 464, 1000}), 10, 5));
}

// Without the missing halves at its ends a wall sheds its overhanging bricks, as it should.
SceneDef closed_wall(std::uint32_t courses) {
  SceneDef scene = on_ground();
  for (std::uint32_t course = 0; course < courses; ++course) {
    const double side = course % 2 == 0 ? -1 : 1, z = 0.5 + course;
    for (int k = 0; k < 7; ++k)
      scene.boxes.push_back(box(scene.boxes.size() + 1, {2, 1, 1}, {(k - 3) * 2.02 + side * 0.5, 0, z}));
    scene.boxes.push_back(box(scene.boxes.size() + 1, {1, 1, 1}, {-side * 7.08, 0, z}));
  }
  return scene;
}

TEST(Stacks, AWallWithClosedEnds) { expect_to_stand("wall", standing(closed_wall(12), 5, 0)); }

// Poles sixty times as long as thick, crosswise: each rests on its ends.
TEST(Stacks, ACabinOfPoles) {
  SceneDef scene = on_ground();
  for (int layer = 0; layer < 20; ++layer) {
    for (const double side : {-2.5, 2.5}) {
      const double z = 0.05 + 0.1 * layer;
      const bool along_x = layer % 2 == 0;
      scene.boxes.push_back(box(scene.boxes.size() + 1, along_x ? Vec3(6, 0.1, 0.1) : Vec3(0.1, 6, 0.1),
                                along_x ? Vec3(0, side, z) : Vec3(side, 0, z)));
    }
  }
  SceneDef cabin = standing(scene, 5, 0);
  for (std::size_t i = 0; i < scene.boxes.size(); ++i) cabin.boxes[i].orientation = scene.boxes[i].orientation;
  expect_to_stand("cabin", cabin);
}

TEST(Stacks, ATableUnderAThousandTimesItsLegs) {
  SceneDef scene = on_ground();
  for (const double x : {-2.0, 2.0}) {
    for (const double y : {-2.0, 2.0}) {
      scene.boxes.push_back(cube(scene.boxes.size() + 1, {x, y, 0.5}));
      scene.boxes.back().size = {0.5, 0.5, 1};
    }
  }
  scene.boxes.push_back(cube(5, {0.3, 0.2, 1.25}));
  scene.boxes.back().size = {5, 5, 0.5};
  scene.boxes.back().mass = 1000;
  expect_to_stand("table", standing(scene, 5, 7));
}

TEST(Stacks, AHeavyBoxDroppedOnATowerStaysThere) {
  SceneDef scene = standing(tower(5), 6, 5);
  scene.boxes.push_back(cube(6, {0.05, 0.02, 6.0}));
  scene.boxes.back().mass = 1000;
  const Outcome outcome = run(scene);
  EXPECT_LT(outcome.gain, 2e-3) << "it is pushed out again of what it sinks in";
  EXPECT_LT(outcome.drift, 0.1) << "the tower has fallen";
}

// The first step already finds every impulse: the weight above, over the points.
TEST(CarryWeights, AContactStartsFromTheWeightItBears) {
  SceneDef scene = standing(tower_of({1, 3, 5}), 1, 0);
  World world = made(scene);
  advance(world);
  const sim::ContactMemory& memory = world.state().contact_memory;
  const double substep = scene.world.dt / scene.world.substeps;
  std::vector<double> borne(3, 0);
  std::size_t point = 0;
  for (std::size_t k = 0; k < memory.size(); ++k) {
    const std::size_t above = memory.a[k] == sim::kGround ? 0 : std::max(memory.a[k], memory.b[k]);
    for (std::uint32_t i = 0; i < memory.count[k]; ++i) borne[above] += memory.impulse[point++];
  }
  EXPECT_NEAR(borne[0], 9 * kGravity * substep, 1e-7);
  EXPECT_NEAR(borne[1], 8 * kGravity * substep, 1e-7);
  EXPECT_NEAR(borne[2], 5 * kGravity * substep, 1e-7);
}

// Sniped out of a stack, a light body must carry its own mass away, not what it was lent.
TEST(CarryWeights, NothingIsLentToAFastBody) {
  SceneDef scene = on_ground();
  scene.boxes = {cube(1, {0, 0, 0.5}), cube(2, {0, 0, 1.5}), cube(3, {1.5, 0, 0.5})};
  scene.boxes[1].mass = 1000;
  for (int i : {0, 1}) scene.boxes[static_cast<std::size_t>(i)].velocity = {5, 0, 0};
  for (sim::BoxDef& box : scene.boxes) box.material.friction = 0;
  scene.world.ground_material.friction = 0;
  World world = made(standing(scene, 1, 0));
  double most = 0;
  for (int k = 0; k < 9; ++k) {  // they meet in the sixth step; the heavy one slides on and comes down much later
    advance(world);
    most = std::max(most, world.bodies().velocity.x[2]);
  }
  EXPECT_LT(most, 4.5) << "with a thousand kilograms lent to the light one it would be 6 m/s";
}

BoxFrame frame_at(const Vec3& half_extent, const Vec3& position) {
  return {position, sim::axes_of({1, 0, 0, 0}), half_extent};
}

TEST(MeetingTime, OfBoxesThatMeetSlantingPassOrTouch) {
  const BoxFrame plate = frame_at({0.025, 2, 2}, {0, 0, 0}), bullet = frame_at({0.05, 0.05, 0.05}, {-5.075, -3.5, 0});
  EXPECT_NEAR(sim::meeting_time(plate, bullet, {300, 210, 0}, 1.0 / 60), 5.0 / 300, 1e-9);
  EXPECT_GE(sim::meeting_time(plate, bullet, {300, 0, 0}, 1.0 / 60), 1.0 / 60) << "passes below the edge";
  EXPECT_GE(sim::meeting_time(plate, bullet, {-300, 0, 0}, 1.0 / 60), 1.0 / 60) << "flies away";
  EXPECT_EQ(sim::meeting_time(plate, frame_at({1, 1, 1}, {1, 0, 0}), {-300, 0, 0}, 1.0 / 60), 0) << "overlaps";
}

TEST(Fast, ASlantingShotDoesNotTunnel) {
  for (const double speed : {30.0, 100.0, 300.0}) {
    SceneDef scene = empty_space();
    scene.boxes = {cube(1, {0, 0, 0}), cube(2, {-5, -3.5, 0.3})};
    scene.boxes[0].size = {0.05, 4, 4};
    scene.boxes[0].mass = 10;
    scene.boxes[1].size = {0.1, 0.1, 0.1};
    scene.boxes[1].mass = 0.1;
    scene.boxes[1].velocity = {speed, 0.7 * speed, 0};
    scene.world.method = sim::Method::kLayered;
    scene.world.dt = 1.0 / 60;
    scene.world.substeps = 8;
    World world = made(scene);
    for (int k = 0; k < 60; ++k) advance(world);
    EXPECT_LT(world.bodies().velocity.x[1], 0) << speed << " m/s";
  }
}

}  // namespace
}  // namespace tumble::test
