// Thesis III.C.1 in whole scenes: a cube between static walls, turned every way, is separated alike.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::BoxDef;
using sim::Quat;
using sim::SceneDef;
using sim::Vec3;
using sim::World;

const double kHalfRoot = std::sqrt(0.5);

Vec3 turned(const Quat& q, const Vec3& v) { return sim::to_world(sim::axes_of(sim::normalised(q)), v); }

// The rotation that turns z into a unit vector, about the axis across both.
Quat from_z_to(const Vec3& n) {
  if (n.z() == -1) return {0, 1, 0, 0};
  const Vec3 half = (n + Vec3(0, 0, 1)) / (n + Vec3(0, 0, 1)).norm();
  return {half.z(), -half.y(), half.x(), 0};
}

// Walls of 8 × 8 × 1 m whose inner faces have these normals and meet in the origin; then a cube of 1 m at `place`.
// Everything is turned by `turn` about the origin.
struct Walls {
  std::vector<Vec3> normals;
  std::vector<double> offsets;  // m, of the faces along their normals
  Quat cube_turn = {1, 0, 0, 0};
  Vec3 place;
};
SceneDef scene_of(const Walls& walls, const Quat& turn) {
  SceneDef scene = empty_space();
  scene.world.substeps = 1;
  BoxDef moving = cube(1, turned(turn, walls.place));
  moving.orientation = sim::normalised(sim::product(turn, walls.cube_turn));
  scene.boxes = {moving};
  for (std::size_t k = 0; k < walls.normals.size(); ++k) {
    BoxDef wall = box(k + 2, {8, 8, 1}, turned(turn, walls.normals[k] * (walls.offsets[k] - 0.5)));
    wall.orientation = sim::normalised(sim::product(turn, from_z_to(walls.normals[k])));
    wall.is_static = true;
    scene.boxes.push_back(wall);
  }
  return scene;
}

// The deepest overlap of the cube with a wall after one step, m; negative: apart.
double overlap_after_a_step(const Walls& walls, const Quat& turn) {
  World world = made(scene_of(walls, turn));
  advance(world);
  const sim::Axes axes = sim::axes_of(world.bodies().orientation[0]);
  double deepest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < walls.normals.size(); ++k) {
    const Vec3 n = turned(turn, walls.normals[k]);
    double reach = 0;
    for (int axis = 0; axis < 3; ++axis) reach += 0.5 * std::fabs(axes[axis].dot(n));
    deepest = std::max(deepest, walls.offsets[k] + reach - world.bodies().position[0].dot(n));
  }
  return deepest;
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

// 360 turns about z, 360 about y (the V's own groove), and 400 about any axis.
Range overlaps_at_any_turn(const Walls& walls) {
  Range range;
  const double degree = std::acos(-1) / 360;
  for (int k = 0; k < 360; ++k) {
    const double c = std::cos(k * degree), s = std::sin(k * degree);
    range.add(overlap_after_a_step(walls, {c, 0, 0, s}));
    range.add(overlap_after_a_step(walls, {c, 0, s, 0}));
  }
  Random random(11);
  for (int k = 0; k < 400; ++k) range.add(overlap_after_a_step(walls, random.rotation()));
  return range;
}

void expect_none_left(const Walls& walls) {
  const Range left = overlaps_at_any_turn(walls);
  EXPECT_LE(left.high, 1e-6);
  EXPECT_LE(left.high - left.low, 1e-9);
}

// A cube 0.1 m deep in both walls of a V of 90°: on its faces, and on its edges. The shortest way out is √2 · 0.1.
TEST(Separation, VIsLeftAtAnyTurn) {
  const std::vector<Vec3> v = {{kHalfRoot, 0, kHalfRoot}, {-kHalfRoot, 0, kHalfRoot}};
  expect_none_left({v, {0, 0}, from_z_to(v[0]), {0, 0, 0.4 / kHalfRoot}});
  expect_none_left({v, {0, 0}, {1, 0, 0, 0}, {0, 0, (kHalfRoot - 0.1) / kHalfRoot}});
}

// A V of 60°: the displacements ask for half of what is needed, and the way out is twice as long as each.
TEST(Separation, NarrowVIsLeftAtAnyTurn) {
  const double c = std::sqrt(0.75);
  expect_none_left({{{c, 0, 0.5}, {-c, 0, 0.5}}, {0, 0}, {1, 0, 0, 0}, {0, 0, 2 * (0.5 * (c + 0.5) - 0.05)}});
}

// Three walls that are square to one another, and the cube 0.05 m deep in each.
TEST(Separation, CornerOfThreeWallsIsLeftAtAnyTurn) {
  expect_none_left({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}, {1, 0, 0, 0}, {0.45, 0.45, 0.45}});
}

// Two walls 0.9 m apart hold a cube of 1 m: 0.07 and 0.03 m deep become 0.05 and 0.05 and stay so.
TEST(Separation, OpposedWallsShareTheOverlap) {
  const Walls walls = {{{0, 0, 1}, {0, 0, -1}}, {0, -0.9}, {1, 0, 0, 0}, {0.1, 0.2, 0.43}};
  const Range left = overlaps_at_any_turn(walls);
  EXPECT_NEAR(left.high, 0.05, 1e-9);
  EXPECT_NEAR(left.low, 0.05, 1e-9);
}

// Walls that are out of parallel by one degree: the way out through their far end is six metres long. The cube stays.
TEST(Separation, NearlyParallelWallsDoNotThrowTheCubeOut) {
  const double tilt = std::acos(-1) / 180;
  const Walls walls = {{{0, 0, 1}, {std::sin(tilt), 0, -std::cos(tilt)}}, {0, -0.9}, {1, 0, 0, 0}, {0, 0, 0.45}};
  World world = made(scene_of(walls, {1, 0, 0, 0}));
  advance(world);
  EXPECT_LT((world.bodies().position[0] - walls.place).norm(), 0.05);
}

}  // namespace
}  // namespace tumble::test
