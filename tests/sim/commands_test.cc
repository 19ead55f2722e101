// The inputs: what each does by the textbook, what work it does, and that a refused one changes nothing.
#include <gtest/gtest.h>

#include <limits>

#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::BoxDef;
using sim::Command;
using sim::SceneDef;
using sim::Vec3;
using sim::World;
using sim::WorldState;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

void expect_near(const Vec3& found, const Vec3& wanted, double tolerance = 1e-11) {
  EXPECT_LT((found - wanted).cwiseAbs().maxCoeff(), tolerance)
      << "found " << found.transpose() << ", wanted " << wanted.transpose();
}

World flying_box() {
  SceneDef scene = empty_space();
  scene.world.gravity = {0, 0, -10};
  scene.boxes = {cube(5, {1, 2, 3})};
  scene.boxes[0].size = {1, 2, 3};
  scene.boxes[0].mass = 12;  // moments 13, 10, 5
  scene.boxes[0].velocity = {1, 0, 0};
  return made(scene);
}

TEST(Push, AtTheCentreChangesVelocityByImpulseOverMass) {
  World world = flying_box();
  give(world, sim::Push{5, {6, 12, -3}});
  expect_near(world.bodies().velocity[0], {1.5, 1, -0.25});
  EXPECT_EQ(world.bodies().spin[0], Vec3(0, 0, 0));
  EXPECT_NEAR(world.input_energy(), 6 * (2.25 + 1 + 0.0625 - 1), 1e-9);
}

// At ½ m beside the centre in x: r × J = (0.5, 0, 0) × (0, 10, 0) = (0, 0, 5), over 5 kg m² is 1 rad/s about z.
TEST(Push, OffCentreTurnsTheBody) {
  World world = flying_box();
  give(world, sim::Push{5, {0, 10, 0}, false, {1.5, 2, 3}});
  expect_near(world.bodies().velocity[0], {1, 10.0 / 12, 0});
  expect_near(world.bodies().spin[0], {0, 0, 1});
}

// Turned a quarter about z, the world's x moment is the body's y moment, 10: (0, 0, 0.5) × (0, −20, 0) = (10, 0, 0).
TEST(Push, UsesTheInertiaAsTheBodyIsTurned) {
  SceneDef scene = empty_space();
  scene.boxes = {cube(5, {0, 0, 0})};
  scene.boxes[0].size = {1, 2, 3};
  scene.boxes[0].mass = 12;
  scene.boxes[0].orientation = turn({0, 0, 1}, 0, 1);
  World world = made(scene);
  give(world, sim::Push{5, {0, -20, 0}, false, {0, 0, 0.5}});
  expect_near(world.bodies().spin[0], {1, 0, 0});
}

// "A frozen body escapes only by the thesis's threshold": ½ v² > 0.0064, v > 0.11314 m/s for 1 kg.
TEST(Push, WakesAFrozenBodyOnlyPastTheEscapeThreshold) {
  SceneDef scene = tower(2);
  freeze_all(scene);
  World world = made(scene);
  const WorldState before = world.state();
  give(world, sim::Push{2, {0.1131, 0, 0}});
  EXPECT_EQ(world.state(), before);
  EXPECT_EQ(world.input_energy(), 0);
  give(world, sim::Push{2, {0.1132, 0, 0}});
  EXPECT_EQ(world.bodies().frozen, (std::vector<std::uint8_t>{1, 0}));
  EXPECT_NEAR(world.bodies().velocity.x[1], 0.1132, 1e-11);
  EXPECT_EQ(world.state().contact_objects.size(), 1U);
}

TEST(Throw, AddsTheBodyWhereItsIdBelongs) {
  SceneDef scene = on_ground();
  scene.boxes = {cube(10, {0, 0, 5}), cube(30, {5, 0, 5})};
  World world = made(scene);
  BoxDef thrown = cube(20, {0, 0, 9});
  thrown.mass = 4;
  thrown.velocity = {3, 0, 0};
  give(world, sim::Throw{thrown});
  EXPECT_EQ(world.bodies().id, (std::vector<sim::BodyId>{10, 20, 30}));
  EXPECT_EQ(world.bodies().position[1], Vec3(0, 0, 9));
  EXPECT_EQ(world.bodies().position[2], Vec3(5, 0, 5));
  EXPECT_EQ(world.bodies().mass, (std::vector<double>{1, 4, 1}));
  EXPECT_NEAR(world.input_energy(), 18 + 4 * 9.81 * 9, 1e-9);
  EXPECT_NEAR(advance(world).inputs, 18 + 4 * 9.81 * 9, 1e-9);
  EXPECT_EQ(advance(world).inputs, 0) << "told once";
}

// Pairs keep pointing at the right bodies, with their planes, when rows move.
TEST(Throw, PairsFollowTheRows) {
  SceneDef scene = empty_space();
  scene.boxes = {cube(10, {0, 0, 0}), cube(30, {1, 0.25, 0})};
  World world = made(scene);
  advance(world);
  ASSERT_EQ(world.state().pairs.size(), 1U);
  const auto planes = world.state().pairs.planes;
  ASSERT_NE(planes[0], 0);
  give(world, sim::Throw{cube(5, {50, 0, 0})});
  give(world, sim::Throw{cube(20, {60, 0, 0})});
  EXPECT_EQ(world.state().pairs, (sim::PairTable{{1}, {3}, planes}));
  give(world, sim::Remove{5});
  EXPECT_EQ(world.state().pairs, (sim::PairTable{{0}, {2}, planes}));
  give(world, sim::Remove{10});
  EXPECT_EQ(world.state().pairs.size(), 0U);
  EXPECT_EQ(world.bodies().id, (std::vector<sim::BodyId>{20, 30}));
}

TEST(Remove, TakesEveryColumnOfTheBodyAway) {
  SceneDef three = on_ground(), two = on_ground();
  three.boxes = {cube(1, {0, 0, 5}), cube(2, {5, 0, 5}), cube(3, {9, 0, 5})};
  for (std::size_t k = 0; k < 3; ++k) {
    BoxDef& b = three.boxes[k];
    const double v = 1 + static_cast<double>(k);
    b.size = {v, 0.5, 0.25};
    b.mass = v;
    b.velocity = b.spin = {v, v, v};
    b.orientation = {1, 0.1 * v, 0, 0};
    b.material = {0.1 * v, 0.05 * v, 0.2 * v};
    b.is_static = k == 0;
  }
  two.boxes = {three.boxes[0], three.boxes[2]};
  World world = made(three);
  give(world, sim::Remove{2});
  EXPECT_EQ(world.state(), made(two).state());
}

TEST(Wake, LeavesTheBodyAtRestAndOthersAlone) {
  SceneDef scene = tower(3);
  freeze_all(scene);
  World world = made(scene);
  give(world, sim::Wake{2});
  EXPECT_EQ(world.bodies().frozen, (std::vector<std::uint8_t>{1, 0, 1}));
  EXPECT_EQ(world.bodies().velocity[1], Vec3(0, 0, 0));
  const WorldState before = world.state();
  give(world, sim::Wake{2});
  EXPECT_EQ(world.state(), before) << "no effect on a body that is awake";
}

TEST(SetVelocity, ReplacesBothVelocitiesAndWakes) {
  SceneDef scene = tower(2);
  freeze_all(scene);
  World world = made(scene);
  give(world, sim::SetVelocity{1, {1, 2, 3}, {4, 5, 6}});
  EXPECT_EQ(world.bodies().velocity[0], Vec3(1, 2, 3));
  EXPECT_EQ(world.bodies().spin[0], Vec3(4, 5, 6));
  EXPECT_EQ(world.bodies().frozen[0], 0);
  EXPECT_NEAR(world.input_energy(), 7 + 77 / 12.0, 1e-9);
}

TEST(SetGravity, ActsFromTheNextStepAndCountsItsWork) {
  World world = flying_box();
  give(world, sim::SetGravity{{0, 0, -4}});
  EXPECT_NEAR(world.input_energy(), 12 * 3 * (4 - 10), 1e-9);
  advance(world);
  EXPECT_NEAR(world.bodies().velocity.z[0], -4.0 / 60, 1e-11);
}

TEST(SetDt, ActsFromTheNextStep) {
  World world = flying_box();
  give(world, sim::SetDt{0.125});
  advance(world);
  EXPECT_EQ(world.bodies().position.x[0], 1.125);
}

TEST(Commands, RefusedOnesNameTheCauseAndChangeNothing) {
  SceneDef scene = on_ground();
  scene.boxes = {cube(1, {0, 0, 5}), cube(2, {5, 0, 5})};
  scene.boxes[1].is_static = true;
  World world = made(scene);
  BoxDef taken = cube(1, {9, 9, 9}), flat = cube(3, {9, 9, 9});
  flat.size.z() = 0;
  const std::vector<std::pair<Command, const char*>> refused = {
      {sim::Throw{taken}, "1"},
      {sim::Throw{flat}, "edge"},
      {sim::Push{9, {1, 0, 0}}, "9"},
      {sim::Push{2, {1, 0, 0}}, "static"},
      {sim::Push{1, {kNan, 0, 0}}, "impulse that is not finite or beyond ±1e+12"},
      {sim::Push{1, {0, 1e13, 0}}, "impulse that is not finite or beyond ±1e+12"},
      {sim::Push{1, {0, 1, 0}, true, {kNan, 0, 0}}, "point"},
      {sim::Push{1, {0, 1, 0}, false, {kNan, 0, 0}}, "point"},
      {sim::Push{1, {1e5, 0, 0}}, "8192"},
      {sim::Remove{9}, "9"},
      {sim::Wake{9}, "9"},
      {sim::SetVelocity{9, {1, 0, 0}, {0, 0, 0}}, "9"},
      {sim::SetVelocity{2, {1, 0, 0}, {0, 0, 0}}, "static"},
      {sim::SetVelocity{1, {9000, 0, 0}, {0, 0, 0}}, "velocity"},
      {sim::SetVelocity{1, {0, 0, 0}, {0, kNan, 0}}, "spin"},
      {sim::SetGravity{{0, kNan, 0}}, "gravity"},
      {sim::SetGravity{{0, 0, 1e5}}, "gravity"},
      {sim::SetDt{0}, "dt"},
      {sim::SetDt{kNan}, "dt"},
      {sim::SetDt{5}, "dt"},
  };
  const WorldState before = world.state();
  for (const auto& [command, word] : refused) {
    const Status status = sim::apply(world, command);
    ASSERT_FALSE(status.ok()) << name_of(command) << ' ' << word;
    EXPECT_EQ(status.error().kind, ErrorKind::kBadInput);
    EXPECT_NE(status.error().message.find(word), std::string::npos) << status.error().message;
    EXPECT_EQ(world.state(), before) << status.error().message;
    EXPECT_EQ(world.input_energy(), 0);
  }
}

TEST(Commands, HaveTheWordsOfTheSceneFormat) {
  const std::vector<std::pair<Command, std::string>> words = {{sim::Throw{}, "throw"},
                                                              {sim::Push{}, "push"},
                                                              {sim::Remove{}, "remove"},
                                                              {sim::Wake{}, "wake"},
                                                              {sim::SetVelocity{}, "set_velocity"},
                                                              {sim::SetGravity{}, "set_gravity"},
                                                              {sim::SetDt{}, "set_dt"}};
  ASSERT_EQ(words.size(), std::variant_size_v<Command>);
  for (const auto& [command, word] : words) EXPECT_EQ(name_of(command), word);
}

}  // namespace
}  // namespace tumble::test
