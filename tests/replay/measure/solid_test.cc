// Bodies of other engines by their own shapes: a ball at rest is not in the ground.
#include "replay/measure/solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "replay/measure/measure_state.h"
#include "tumble/sim/rotation.h"

namespace tumble::replay {
namespace {

using sim::Quat;
using sim::Vec3;

const Quat kUpright = {1, 0, 0, 0};
const Quat kSlanting = {std::cos(0.4), std::sin(0.4), 0, 0};
const Quat kLying = {std::sqrt(0.5), 0, std::sqrt(0.5), 0};  // z to x

Shape sphere(double radius) { return {.kind = Shape::Kind::kSphere, .radius = radius}; }
Shape capsule(double radius, double half) {
  return {.kind = Shape::Kind::kCapsule, .axis = 2, .radius = radius, .half_length = half};
}
Shape cylinder(double radius, double half) {
  return {.kind = Shape::Kind::kCylinder, .axis = 2, .radius = radius, .half_length = half};
}

Solid at(const Vec3& place, const Shape& shape, const Quat& turn = kUpright) {
  return {{place, sim::axes_of(turn), size_of(shape) / 2}, &shape};
}

TEST(Solid, ABallRestsOnTheGroundHoweverItIsTurned) {
  const Shape ball = sphere(0.5);
  for (const Quat& turn : {kUpright, kSlanting, kLying}) {
    EXPECT_EQ(ground_penetration(at({3, 4, 0.5}, ball, turn)), 0);
    EXPECT_NEAR(ground_penetration(at({3, 4, 0.375}, ball, turn)), 0.125, 1e-15);
  }
  const Shape pill = capsule(0.25, 0.5), drum = cylinder(0.5, 0.25);
  EXPECT_NEAR(ground_penetration(at({0, 0, 0.5}, pill)), 0.25, 1e-15) << "0.75 up to its cap";
  EXPECT_NEAR(ground_penetration(at({0, 0, 0.25}, pill, kLying)), 0, 1e-15);
  EXPECT_NEAR(ground_penetration(at({0, 0, 0.25}, drum)), 0, 1e-15);
  EXPECT_NEAR(ground_penetration(at({0, 0, 0.25}, drum, kLying)), 0.25, 1e-15);
  Shape hull = {.kind = Shape::Kind::kHull, .points = {{0, 0, -1}, {1, 0, 1}, {-1, 1, 1}, {-1, -1, 1}}};
  EXPECT_NEAR(ground_penetration(at({0, 0, 0.75}, hull)), 0.25, 1e-15);
}

TEST(Solid, OverlapsOfBallsPillsAndBoxesAreExact) {
  const Shape ball = sphere(0.5), pill = capsule(0.25, 0.5);
  const Solid box = {{{0, 0, 0}, sim::axes_of(kUpright), {1, 1, 1}}, nullptr};
  EXPECT_NEAR(overlap_depth(at({0, 0, 0}, ball, kSlanting), at({0.6, 0, 0.8}, ball)), 0, 1e-15);
  EXPECT_NEAR(overlap_depth(at({0, 0, 0}, ball), at({0.45, 0, 0.6}, ball)), 0.25, 1e-15);
  EXPECT_NEAR(overlap_depth(at({1.3, 1.4, 0}, ball), box), 0, 1e-15) << "0.5 from its edge";
  EXPECT_NEAR(overlap_depth(box, at({0, 0, 1.25}, ball)), 0.25, 1e-15);
  EXPECT_NEAR(overlap_depth(box, at({0, 0, 0.75}, ball)), 0.75, 1e-15) << "its centre is inside";
  EXPECT_NEAR(overlap_depth(at({0, 0, 0}, pill), at({0.375, 0, 0.1}, pill)), 0.125, 1e-15) << "side by side";
  EXPECT_NEAR(overlap_depth(at({0, 0, 0}, pill), at({0, 0.375, 0}, pill, kLying)), 0.125, 1e-12) << "crossed";
  EXPECT_NEAR(overlap_depth(at({0, 0, 0}, pill), at({0, 0, 1.125}, ball)), 0.125, 1e-15) << "on its cap";
  EXPECT_TRUE(overlap_is_exact(at({0, 0, 0}, pill), at({0, 0, 1.125}, ball)));
}

TEST(Solid, OtherOverlapsAreUpperBoundsCloseToTheTruth) {
  const Shape drum = cylinder(0.5, 0.25), ball = sphere(0.5), pill = capsule(0.25, 0.5);
  const Solid box = {{{0, 0, 0}, sim::axes_of(kUpright), {1, 1, 1}}, nullptr};
  EXPECT_NEAR(overlap_depth(at({0, 0, 1.125}, drum), box), 0.125, 1e-9);
  EXPECT_NEAR(overlap_depth(at({0, 0, 1.4375}, drum, kLying), box), 0.0625, 1e-9) << "on its side";
  EXPECT_NEAR(overlap_depth(at({0, 0, 0}, drum), at({0.6, 0.6, 0.1}, ball)), 1 - std::sqrt(0.72), 1e-6) << "beside it";
  EXPECT_EQ(overlap_depth(at({0, 0, 0}, drum), at({0.75, 0.75, 0.1}, ball)), 0);
  EXPECT_NEAR(overlap_depth(at({0, 0, 1.625}, pill), box), 0.125, 1e-9);
  EXPECT_FALSE(overlap_is_exact(at({0, 0, 1.625}, pill), box));
  bool upper_bound = false;
  const std::vector<Solid> two = {box, at({0, 0, 1.125}, drum)};
  EXPECT_NEAR(deepest_overlap(two, std::vector<std::uint8_t>{0, 0}, upper_bound), 0.125, 1e-9);
  EXPECT_TRUE(upper_bound);
  EXPECT_EQ(deepest_overlap(two, std::vector<std::uint8_t>{1, 1}, upper_bound), 0);
}

TEST(Solid, InertiasAreThoseOfTheShapes) {
  const Vec3 ball = inertia_of(sphere(0.5), 2, {1, 1, 1}), drum = inertia_of(cylinder(0.5, 0.75), 12, {1, 1, 1.5});
  EXPECT_NEAR(ball.x(), 0.2, 1e-15);
  EXPECT_NEAR(drum.z(), 1.5, 1e-15);
  EXPECT_NEAR(drum.x(), 3 * 0.25 + 2.25, 1e-15);
  const Vec3 round = inertia_of(capsule(0.5, 0), 2, {1, 1, 1});
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(round[k], 0.2, 1e-15) << "a capsule without a tube is a ball";
}

TEST(Solid, AMeshIsLeftOutAndSaidToBe) {
  const Shape mesh = {
      .kind = Shape::Kind::kMesh, .points = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, .triangles = {0, 1, 2}};
  BodyTable table;
  table.add({{1, "rock", hash_of(mesh)}}, {mesh});
  sim::SceneDef scene;
  sim::BoxDef box;
  box.id = 1;
  box.size = {2, 2, 1};
  box.position = {0, 0, 0.25};
  scene.boxes.push_back(box);
  BodyStates states;
  states.id = {1};
  states.position = {{0}, {0}, {0.25}};
  states.orientation = {{1}, {0}, {0}, {0}};
  states.velocity = states.spin = {{0}, {0}, {0}};
  states.frozen = {0};
  StateMeter meter(scene, states, {}, table);
  EXPECT_EQ(meter.measure(states).ground_penetration_max, 0) << "its points are above, its box is not";
  EXPECT_EQ(meter.overlap_max(states), 0);
  ASSERT_EQ(meter.approximations().size(), 2U);
  EXPECT_EQ(meter.approximations().front(), "overlaps of 1 body with a mesh are not measured");
  StateMeter boxes(scene, states);
  EXPECT_EQ(boxes.measure(states).ground_penetration_max, 0.25);
  EXPECT_TRUE(boxes.approximations().empty());
  EXPECT_FALSE(boxes.kinetic_by_shapes(states).has_value());
}

}  // namespace
}  // namespace tumble::replay
