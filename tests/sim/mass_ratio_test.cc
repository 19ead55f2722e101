// Bodies whose masses differ by up to ten million: sums of their impulses are exact all the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "src/math/grid.h"
#include "src/world/scratch.h"
#include "tests/support/sim_scenes.h"
#include "tests/support/transforms.h"

namespace tumble::test {
namespace {

using sim::BoxDef;
using sim::SceneDef;
using sim::Vec3;
using sim::World;

constexpr std::uint64_t kScenes = 1000;  // of each method
constexpr std::uint64_t kSteps = 60;
constexpr double kLargestRatio = 1e7;

SceneDef with_method(sim::Method method) {
  SceneDef scene = on_ground();
  scene.world.method = method;
  scene.world.dt = 1.0 / 60;
  return scene;
}

double power_of_ten(double exponent) { return std::pow(10.0, exponent); }

// A box with edges of 5 cm to 1.2 m; its mass is a random part of the ratio times the lightest.
BoxDef random_box(Random& random, sim::BodyId id, double lightest_kg, double part_of_ratio, double ratio) {
  BoxDef box = cube(id, {0, 0, 0});
  const double edge = power_of_ten(random.uniform(-1.1, 0));
  for (int k = 0; k < 3; ++k) box.size[k] = edge * random.uniform(0.6, 1.2);
  box.mass = lightest_kg * std::pow(ratio, part_of_ratio);
  box.material.friction = random.uniform(0, 1);
  box.material.friction_dynamic = box.material.friction * random.uniform(0.5, 1);
  box.material.restitution = random.uniform(0, 0.5);
  return box;
}

// Two to sixteen boxes: some in a stack in any order of mass, the others thrown at it. The lightest and the heaviest
// are always there.
SceneDef random_scene(std::uint64_t seed, sim::Method method) {
  Random random(seed);
  SceneDef scene = with_method(method);
  scene.world.substeps = 1U << (random.next() % 4);
  scene.steps = kSteps;
  const double ratio = std::pow(kLargestRatio, random.uniform(0.2, 1));
  const double lightest = power_of_ten(random.uniform(-3, -1));
  const auto count = static_cast<sim::BodyId>(2 + random.next() % 15);
  const auto stacked = static_cast<sim::BodyId>(random.next() % (count + 1));
  double top = 0;
  std::vector<double> parts = {0, 1};
  while (parts.size() < count) parts.push_back(random.uniform(0, 1));
  shuffle(parts, random);
  for (sim::BodyId id = 1; id <= count; ++id) {
    BoxDef box = random_box(random, id, lightest, parts[id - 1], ratio);
    if (id <= stacked) {
      const double aside = 0.2 * box.size.x();
      const double x = random.uniform(-aside, aside), y = random.uniform(-aside, aside);
      box.position = {x, y, top + 0.5 * box.size.z()};
      top += box.size.z();
    } else {
      box.position = random_vector(random, 1.5) + Vec3(0, 0, 2);
      box.velocity = random_vector(random, 6);
      box.spin = random_vector(random, 6);
      box.orientation = random.rotation();
    }
    scene.boxes.push_back(box);
  }
  return resolved(scene);
}

// The message of the first step that fails; empty if none does.
std::string run_to_the_end(World& world, std::uint64_t steps) {
  while (world.state().step < steps) {
    if (const auto ok = step(world); !ok.ok()) return ok.error().message;
  }
  return "";
}

class MassRatio : public testing::TestWithParam<sim::Method> {};

TEST_P(MassRatio, UpToTenMillionEveryTransformedSceneMovesBitForBitAlike) {
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    const SceneDef scene = random_scene(seed, GetParam());
    World original = made(scene);
    ASSERT_EQ(run_to_the_end(original, scene.steps), "") << "seed " << seed;
    for (const Transform& transform : all_transforms()) {
      const IdMap ids = ids_under(scene, transform);
      World transformed = made(image_of(scene, transform, ids));
      ASSERT_EQ(run_to_the_end(transformed, scene.steps), "") << "seed " << seed << ", " << to_string(transform);
      EXPECT_EQ(differing_bodies(original, transformed, transform, ids), 0U)
          << "seed " << seed << ", " << scene.boxes.size() << " bodies, " << to_string(transform);
    }
  }
}

// A lane that needs a wider grid changes nothing in the others.
TEST_P(MassRatio, UpToTenMillionOneLaneGivesTheBitsOfTheWidest) {
  for (std::uint64_t seed = 1; seed <= kScenes / 5; ++seed) {
    const SceneDef scene = random_scene(seed, GetParam());
    World widest = made(scene), one = made(scene);
    one.mutable_scratch().lanes = sim::LaneWidth::kOne;
    ASSERT_EQ(run_to_the_end(widest, scene.steps), "") << "seed " << seed;
    ASSERT_EQ(run_to_the_end(one, scene.steps), "") << "seed " << seed;
    EXPECT_EQ(widest.state(), one.state()) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, MassRatio, testing::Values(sim::Method::kThesis, sim::Method::kLayered),
                         [](const auto& row) { return row.param == sim::Method::kThesis ? "thesis" : "layered"; });

// Two boxes of 211 kg and 2.3 g.
TEST(MassRatios, AHeavyBoxOnALightOneMovesAsItsMirrorImage) {
  SceneDef scene = with_method(sim::Method::kLayered);
  scene.world.substeps = 8;
  scene.boxes = {cube(1, {0, 0, 0.1}), cube(2, {0.06, 0.03, 0.75})};
  scene.boxes[0].mass = 0.0023;
  scene.boxes[0].size = {0.3, 0.25, 0.2};
  scene.boxes[1].mass = 211;
  scene.boxes[1].orientation = turn({1, 0, 0}, 0.995, std::sqrt(1 - 0.995 * 0.995));
  scene.boxes[1].velocity = {0.7, -0.4, -5};
  scene = resolved(scene);
  World original = made(scene);
  ASSERT_EQ(run_to_the_end(original, kSteps), "");
  for (const Transform& transform : all_transforms()) {
    const IdMap ids = ids_under(scene, transform);
    World transformed = made(image_of(scene, transform, ids));
    ASSERT_EQ(run_to_the_end(transformed, kSteps), "");
    EXPECT_EQ(differing_bodies(original, transformed, transform, ids), 0U) << to_string(transform);
  }
}

// Where a number leaves the grids, a step fails, and its message names the bodies, the quantity and the limit.
TEST(MassRatios, LayeredNamesBodiesQuantityAndLimitOfAMotionBeyondTheGrids) {
  SceneDef scene = with_method(sim::Method::kLayered);
  scene.world.dt = 1e-5;
  scene.world.ground = false;
  scene.boxes = {cube(3, {0, 0.5004, 5}), cube(8, {0.6, 0, 5})};  // only an edge of the small one is hit
  scene.boxes[0].size = {0.001, 0.001, 0.001};
  scene.boxes[0].mass = 0.002;
  scene.boxes[0].velocity = {8000, 0, 0};
  scene.boxes[1].size = {0.99, 1, 1};
  scene.boxes[1].mass = 4000;
  scene.boxes[1].velocity = {-8000, 0, 0};
  World world = made(scene);
  const std::string message = run_to_the_end(world, 20);
  for (const char* part : {"step 1, phase integrate_positions: body 3 (0.002 kg) on body 8 (4e+03 kg): found spin (",
                           "wanted finite and within ±131072 rad/s"}) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }
}

// Four boxes meet a light one at one time, from four sides.
TEST(MassRatios, ThesisNamesABodyWhoseGainsTogetherLeaveTheGrid) {
  SceneDef scene = empty_space();
  scene.boxes = {cube(1, {0, 0, 0})};
  scene.boxes[0].material.restitution = 0;
  for (const Vec3& side : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)}) {
    BoxDef heavy = cube(scene.boxes.size() + 1, side * 0.999);
    heavy.mass = 1e7;
    heavy.material.restitution = 0;
    heavy.velocity = side * -7000;
    scene.boxes.push_back(heavy);
  }
  scene.world.dt = 1e-7;
  World world = made(scene);
  EXPECT_EQ(
      run_to_the_end(world, 1),
      "step 1, phase compute_impulses: body 1: found gains of 27999.9972 m/s or rad/s together in one substep, wanted "
      "at most 24576, where their sum is exact; use smaller speeds, a smaller dt or less extreme masses");
}

// One sum in many orders, of terms that the usual grid holds or does not.
TEST(FittingMagic, MakesSumsOfAnySizeExactInAnyOrder) {
  Random random(5);
  for (int round = 0; round < 1000; ++round) {
    const double scale = power_of_ten(random.uniform(-6, 12));
    std::vector<double> terms;
    double largest = 0;
    for (int k = 0; k < 60; ++k) {
      terms.push_back(random.uniform(-scale, scale));
      largest = std::max(largest, std::fabs(terms.back()));
    }
    const double magic = sim::fitting_magic(sim::VelocityGrid::kMagic, largest * static_cast<double>(terms.size()));
    double first = 0, mirrored = 0, shuffled = 0;
    for (const double x : terms) first += (x + magic) - magic;
    for (const double x : terms) mirrored += (-x + magic) - magic;
    shuffle(terms, random);
    for (const double x : terms) shuffled += (x + magic) - magic;
    EXPECT_EQ(first, shuffled) << "terms of " << scale;
    EXPECT_EQ(first, -mirrored) << "terms of " << scale;
    EXPECT_LE(std::fabs(sim::VelocityGrid::round_any(scale) - scale), 1e-15 * scale + 2e-12);
    EXPECT_EQ(sim::VelocityGrid::round_any(-scale), -sim::VelocityGrid::round_any(scale));
  }
}

}  // namespace
}  // namespace tumble::test
