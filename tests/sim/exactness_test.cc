// Neither names, nor the order of insertion, nor where and which way round a scene stands changes a bit of it.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include "src/math/grid.h"
#include "tests/support/sim_scenes.h"
#include "tests/support/transforms.h"

namespace tumble::test {
namespace {

using sim::SceneDef;
using sim::Vec3;
using sim::World;

void apply_inputs(World& world, const SceneDef& scene) {
  for (const sim::TimedCommand& input : scene.inputs) {
    if (input.step == world.state().step + 1) give(world, input.command);
  }
}

// The first step after which the two runs differ, and in how many bodies; step 0 with no bodies when they never do.
struct Difference {
  std::uint64_t step = 0;
  std::size_t bodies = 0;
};
std::ostream& operator<<(std::ostream& out, const Difference& difference) {
  return out << difference.bodies << " bodies at step " << difference.step;
}

// Runs the scene and its image side by side. `disturb` (if not 0) is the step after which the first body of the image
// is moved by one step of the grid: whatever stands in its row, so it is what a dependence on order would look like.
Difference compare(const SceneDef& given, const Transform& transform, std::uint64_t disturb = 0) {
  const SceneDef scene = resolved(given);
  const IdMap names = ids_under(scene, transform);
  const SceneDef image_scene = image_of(scene, transform, names);
  World original = made(scene), image = made(image_scene);
  if (const std::size_t n = differing_bodies(original, image, transform, names); n > 0) return {0, n};
  while (original.state().step < scene.steps) {
    apply_inputs(original, scene);
    apply_inputs(image, image_scene);
    advance(original);
    advance(image);
    if (disturb == image.state().step) image.mutable_state().bodies.position.x[0] += sim::PositionGrid::kStep;
    if (const std::size_t n = differing_bodies(original, image, transform, names); n > 0) {
      return {original.state().step, n};
    }
  }
  return {};
}

SceneDef with(SceneDef scene, std::uint64_t steps, double dt, std::uint32_t substeps) {
  scene.steps = steps;
  scene.world.dt = dt;
  scene.world.substeps = substeps;
  return scene;
}

SceneDef jittered(SceneDef scene, double amount) {
  jitter(scene, amount, 7);
  return scene;
}

SceneDef frozen_wall_hit() {
  SceneDef scene = wall(6, 6);
  freeze_all(scene);
  add_thrown_cube(scene);
  return with(scene, 120, 1.0 / 60, 8);
}

// Cubes fall on the edges of static ones, and tip over them.
SceneDef static_edges() {
  SceneDef scene = with(jittered(pile(4), 0.1), 120, 1.0 / 60, 4);
  for (sim::BoxDef& b : scene.boxes) b.position.z() += 1.5;
  for (int k = 0; k < 9; ++k) {
    const int column = k % 3, row = k / 3;
    scene.boxes.push_back(cube(101 + static_cast<sim::BodyId>(k), {1.75 * column, 1.75 * row, 0.5}));
    scene.boxes.back().is_static = true;
  }
  return scene;
}

// Every kind of input in the middle of a run.
SceneDef session() {
  SceneDef scene = with(jittered(pile(3), 0.02), 150, 1.0 / 60, 4);
  sim::BoxDef late = cube(100, {0.2, -4, 2});
  late.velocity = {0, 12, 1};
  late.spin = {1, 2, 3};
  late.size = {0.5, 1.5, 0.75};
  sim::BoxDef later = late;
  later.id = 50;
  later.position = {4, 0.1, 3};
  later.velocity = {-9, 0, 0};
  scene.inputs = {{20, sim::Throw{late}},
                  {40, sim::Push{5, {3, -2, 1}, false, {0.25, 0.5, 1.5}}},
                  {40, sim::SetDt{1.0 / 90}},
                  {55, sim::Throw{later}},
                  {60, sim::SetVelocity{9, {1, 2, 3}, {-1, 4, 2}}},
                  {80, sim::Remove{14}},
                  {90, sim::SetGravity{{1.5, -2.25, -9}}},
                  {110, sim::Wake{3}},
                  {120, sim::SetGravity{{0, 0, -9.81}}}};
  return scene;
}

struct Case {
  std::string name;
  SceneDef scene;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

std::vector<Case> cases() {
  constexpr double k60 = 1.0 / 60, k30 = 1.0 / 30;
  return {
      {"tilted_grid", with(tilted_grid(10), 100, k30, 4)},
      {"jittered_pile_1", with(jittered(pile(6), 0.02), 120, k60, 1)},
      {"jittered_pile_8", with(jittered(pile(6), 0.02), 60, k60, 8)},
      {"frozen_wall_hit", frozen_wall_hit()},
      {"jittered_wall", with(jittered(wall(6, 6), 0.01), 100, k60, 4)},
      {"pyramid", with(pyramid(10), 120, k60, 4)},
      {"tumble", with(tumble_of_boxes(7, 3), 100, k60, 2)},
      {"size_ratio", with(size_ratio(), 300, k60, 8)},
      {"plates_and_bars", with(plates_and_bars(24, 11), 250, k60, 8)},
      {"static_ramp", with(ramp(24, 5), 250, k60, 4)},
      {"static_edges", static_edges()},
      {"session", session()},
  };
}

class Exactness : public testing::TestWithParam<Case> {};

TEST_P(Exactness, EveryImageMovesBitForBitAlike) {
  for (const Transform& transform : all_transforms()) {
    const Difference difference = compare(GetParam().scene, transform);
    EXPECT_EQ(difference.bodies, 0U) << to_string(transform) << ": " << difference;
  }
}

// A comparison that cannot fail is worth nothing: one grid step in the body of the first row must show.
TEST_P(Exactness, CanaryOfOneGridStepIsSeen) {
  for (const Transform& transform : all_transforms()) {
    const Difference difference = compare(GetParam().scene, transform, 10);
    EXPECT_EQ(difference.step, 10U) << to_string(transform);
    EXPECT_EQ(difference.bodies, 1U) << to_string(transform);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Exactness, testing::ValuesIn(cases()), [](const auto& row) { return row.param.name; });

// Boxes on a coarse lattice, turned by round angles, overlapping and even in one place: exact ties everywhere, which
// is where an order would show.
SceneDef lattice_of_ties(std::uint64_t seed) {
  Random random(seed);
  const auto one_of = [&](const std::vector<double>& values) { return values[random.next() % values.size()]; };
  const double half_root = std::sqrt(0.5);
  SceneDef scene = with(on_ground(), 40, 1.0 / 64, 4);
  for (sim::BodyId id = 1; id <= 40; ++id) {
    const double x = one_of({-1, -0.5, 0, 0.25, 1}), y = one_of({-1, -0.5, 0, 0.25, 1});
    sim::BoxDef b = cube(id, {x, y, one_of({0.25, 0.5, 1, 1.5, 2, 3})});
    const double sx = one_of({0.5, 1}), sy = one_of({0.5, 1});
    b.size = {sx, sy, one_of({0.5, 1})};
    b.mass = one_of({1, 1, 2});
    const Vec3 axis = std::vector<Vec3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}[random.next() % 3];
    b.orientation = turn(axis, 1, 0);
    if (random.next() % 2 == 0) b.orientation = turn(axis, half_root, half_root);
    if (random.next() % 4 == 0) b.orientation = turn(axis, 0, 1);
    const double vx = one_of({-1, 0, 1}), vy = one_of({-1, 0, 1});
    b.velocity = {vx, vy, 0};
    b.frozen = random.next() % 5 == 0;
    b.is_static = random.next() % 10 == 0;
    scene.boxes.push_back(b);
  }
  return scene;
}

TEST(ExactTies, AreNeverDecidedByNames) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const SceneDef scene = lattice_of_ties(seed);
    for (const Transform& transform : all_transforms()) {
      const Difference difference = compare(scene, transform);
      EXPECT_EQ(difference.bodies, 0U) << "seed " << seed << ", " << to_string(transform) << ": " << difference;
    }
  }
}

// The disturbance must also spread, or the scene never let its bodies meet.
TEST(ExactnessCanary, OneGridStepReachesOtherBodiesWithinTheRun) {
  for (const Case& c : cases()) {
    const SceneDef scene = resolved(c.scene);
    World original = made(scene), disturbed = made(scene);
    const Transform same;
    const IdMap names = ids_under(scene, same);
    while (original.state().step < scene.steps) {
      for (World* world : {&original, &disturbed}) {
        apply_inputs(*world, scene);
        advance(*world);
      }
      if (original.state().step != 2) continue;
      sim::Vec3Column& position = disturbed.mutable_state().bodies.position;
      for (double& x : position.x) {
        if (&x == &position.x.front() || &x == &position.x.back()) x += 1e6 * sim::PositionGrid::kStep;
      }
    }
    EXPECT_GT(differing_bodies(original, disturbed, same, names), 2U) << c.name;
  }
}

// create_world takes ascending ids only; bodies thrown in before the first step arrive in any order.
TEST(InsertionOrder, ShowsInNothing) {
  for (const SceneDef& scene :
       {with(jittered(pile(4), 0.02), 60, 1.0 / 60, 4), with(tumble_of_boxes(4, 9), 60, 0.02, 2)}) {
    SceneDef empty = scene;
    empty.boxes.clear();
    std::vector<sim::BoxDef> order = scene.boxes;
    Random random(21);
    shuffle(order, random);
    ASSERT_NE(order, scene.boxes);
    World created = made(scene), filled = made(empty);
    for (const sim::BoxDef& box : order) give(filled, sim::Throw{box});
    for (std::uint64_t k = 0; k < scene.steps; ++k) {
      ASSERT_EQ(created.state(), filled.state()) << "step " << k;
      advance(created);
      advance(filled);
    }
    EXPECT_EQ(created.state(), filled.state());
  }
}

// Reflections are their own inverses and the transforms are what design says of a mirror in x.
TEST(Transforms, MirrorInXIsTheOneOfTheDesign) {
  const Transform& mirror = all_transforms()[0];
  EXPECT_EQ(mirror.orientation({0.1, 0.2, 0.3, 0.4}), (sim::Quat{0.1, 0.2, -0.3, -0.4}));
  EXPECT_EQ(mirror.axial_vector({1, 2, 3}), Vec3(1, -2, -3));
  EXPECT_EQ(mirror.point({1, 2, 3}), Vec3(-1, 2, 3));
}

// v_W = R v_B: the image of a turned vector is the turned image of it, for every transform. (Box axes swap with x, y.)
TEST(Transforms, OrientationsTurnTheImageAsTheOriginalTurns) {
  const sim::Quat q = sim::normalised({0.3, -0.5, 0.7, 0.2});
  const sim::Axes axes = axes_of(q);
  for (const Transform& t : all_transforms()) {
    const sim::Axes image = axes_of(t.orientation(q));
    const Vec3 body(0.3, -1.2, 0.6);
    const Vec3 moved = t.vector(to_world(axes, body));
    const Vec3 again = to_world(image, t.vector(body));
    EXPECT_LT((moved - again).cwiseAbs().maxCoeff(), 1e-15) << to_string(t);
  }
}

}  // namespace
}  // namespace tumble::test
