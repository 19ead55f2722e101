// World: creation, the floating-point environment, energy.
#include "tumble/sim/world.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <functional>
#include <limits>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "src/math/grid.h"
#include "tests/support/sim_scenes.h"
#include "tumble/sim/world_state.h"

namespace tumble::test {
namespace {

using sim::BoxDef;
using sim::PositionGrid;
using sim::SceneDef;
using sim::Vec3;
using sim::VelocityGrid;
using sim::World;
using sim::WorldDef;
using sim::WorldState;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(WorldCreate, RoundsToTheGridsAndNormalises) {
  SceneDef scene = on_ground();
  scene.boxes = {cube(1, {0.1, -0.2, 0.7})};
  scene.boxes[0].velocity = {1.0 / 3, -0.0, 0};
  scene.boxes[0].spin = {0, 1e-13, -1.0 / 7};
  scene.boxes[0].orientation = {2, 0, -0.0, 2};
  const World world = made(scene);
  const sim::Bodies& b = world.bodies();
  for (const double x : {b.position.x[0], b.position.y[0], b.position.z[0]}) {
    EXPECT_EQ(std::ldexp(x, 36), std::round(std::ldexp(x, 36)));
  }
  EXPECT_EQ(b.position.x[0], std::ldexp(std::round(std::ldexp(0.1, 36)), -36));
  EXPECT_EQ(b.velocity.x[0], std::ldexp(std::round(std::ldexp(1.0 / 3, 38)), -38));
  EXPECT_EQ(b.spin.y[0], 0) << "less than half a grid step";
  EXPECT_FALSE(std::signbit(b.velocity.y[0]));
  EXPECT_FALSE(std::signbit(b.orientation.y[0]));
  EXPECT_NEAR(b.orientation.w[0], std::sqrt(0.5), 2e-16);
}

// Wrong boxes, each with a word that the message must have besides the body's id.
TEST(WorldCreate, RefusesBoxesBeyondTheLimits) {
  const std::vector<std::pair<const char*, std::function<void(BoxDef&)>>> faults = {
      {"edge", [](BoxDef& b) { b.size.y() = 0; }},
      {"edge", [](BoxDef& b) { b.size.x() = -1; }},
      {"edge", [](BoxDef& b) { b.size.z() = kNan; }},
      {"edge", [](BoxDef& b) { b.size.z() = 5000; }},
      {"mass", [](BoxDef& b) { b.mass = 0; }},
      {"mass", [](BoxDef& b) { b.mass = kNan; }},
      {"mass", [](BoxDef& b) { b.mass = 1e13; }},
      {"position", [](BoxDef& b) { b.position.x() = 40000; }},
      {"position", [](BoxDef& b) { b.position.y() = kNan; }},
      {"velocity", [](BoxDef& b) { b.velocity.z() = -9000; }},
      {"velocity", [](BoxDef& b) { b.velocity.z() = kInfinity; }},
      {"spin", [](BoxDef& b) { b.spin.x() = 9000; }},
      {"orientation",
       [](BoxDef& b) {
         b.orientation = {0, 0, 0, 0};
       }},
      {"orientation", [](BoxDef& b) { b.orientation.z = kNan; }},
      {"material", [](BoxDef& b) { b.material.friction = -0.1; }},
      {"material", [](BoxDef& b) { b.material.friction_dynamic = kNan; }},
      {"material", [](BoxDef& b) { b.material.restitution = -1; }},
      {"material", [](BoxDef& b) { b.material.restitution = 1.01; }},
  };
  for (const auto& [word, spoil] : faults) {
    SceneDef scene = on_ground();
    scene.boxes = {cube(7, {0, 0, 5}), cube(42, {3, 0, 5})};
    spoil(scene.boxes[1]);
    const auto world = create_world(scene);
    ASSERT_FALSE(world.ok()) << word;
    EXPECT_EQ(world.error().kind, ErrorKind::kBadInput);
    EXPECT_NE(world.error().message.find("body 42"), std::string::npos) << world.error().message;
    EXPECT_NE(world.error().message.find(word), std::string::npos) << world.error().message;
  }
}

TEST(WorldCreate, RefusesIdsThatDoNotAscend) {
  for (const sim::BodyId second : {7U, 6U, 0U}) {
    SceneDef scene = on_ground();
    scene.boxes = {cube(7, {0, 0, 5}), cube(second, {3, 0, 5})};
    EXPECT_FALSE(create_world(scene).ok()) << second;
  }
  SceneDef scene = on_ground();
  scene.boxes = {cube(sim::kBodyIdMax + 1, {0, 0, 5})};
  EXPECT_FALSE(create_world(scene).ok());
  scene.boxes[0].id = sim::kBodyIdMax;
  EXPECT_TRUE(create_world(scene).ok());
}

TEST(WorldCreate, RefusesParametersBeyondTheLimits) {
  const std::vector<std::function<void(WorldDef&)>> faults = {
      [](WorldDef& d) { d.dt = 0; },
      [](WorldDef& d) { d.dt = -0.1; },
      [](WorldDef& d) { d.dt = 2; },
      [](WorldDef& d) { d.dt = kNan; },
      [](WorldDef& d) { d.substeps = 0; },
      [](WorldDef& d) { d.method = static_cast<sim::Method>(7); },
      [](WorldDef& d) { d.substeps = 2000; },
      [](WorldDef& d) { d.gravity.x() = kNan; },
      [](WorldDef& d) { d.gravity.z() = -1e5; },
      [](WorldDef& d) { d.freeze_energy = -1; },
      [](WorldDef& d) { d.freeze_time = kNan; },
      [](WorldDef& d) { d.slip_speed = -1; },
      [](WorldDef& d) { d.air_drag = -1; },
      [](WorldDef& d) { d.air_drag = kInfinity; },
      [](WorldDef& d) { d.ground_material.friction = kNan; },
      [](WorldDef& d) { d.ground_material.restitution = 1.01; },
  };
  std::size_t k = 0;
  for (const auto& spoil : faults) {
    SceneDef scene = on_ground();
    spoil(scene.world);
    EXPECT_FALSE(create_world(scene).ok()) << "fault " << k;
    ++k;
  }
}

// The environment is set back by the destructor, or every later test would be wrong.
class Rounding {
 public:
  explicit Rounding(int mode) : old_(std::fegetround()) { std::fesetround(mode); }
  ~Rounding() { std::fesetround(old_); }

 private:
  int old_;
};

TEST(FloatEnvironment, OtherRoundingModesAreRefused) {
  const SceneDef scene = tower(2);
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    const Rounding rounding(mode);
    const auto world = create_world(scene);
    ASSERT_FALSE(world.ok()) << mode;
    EXPECT_EQ(world.error().kind, ErrorKind::kCannotFinish);
    EXPECT_NE(world.error().message.find("round"), std::string::npos) << world.error().message;
  }
  EXPECT_TRUE(create_world(scene).ok()) << "restored";
  const WorldState state = made(scene).state();
  const Rounding rounding(FE_UPWARD);
  EXPECT_FALSE(World::restore(state).ok());
}

#if defined(__SSE2__)
TEST(FloatEnvironment, FlushedSubnormalsAreRefused) {
  const SceneDef scene = tower(2);
  const unsigned old = _mm_getcsr();
  for (const unsigned flag : {0x8000U, 0x0040U, 0x8040U}) {  // FTZ, DAZ, both
    _mm_setcsr(old | flag);
    const auto world = create_world(scene);
    _mm_setcsr(old);
    ASSERT_FALSE(world.ok()) << flag;
    EXPECT_NE(world.error().message.find("subnormal"), std::string::npos) << world.error().message;
  }
  EXPECT_TRUE(create_world(scene).ok()) << "restored";
}
#endif

// Energies by hand: ½ m v² + ½ I w², −m g·x; a cube of 6 kg has I = 1 about any axis.
TEST(Energy, IsThatOfTheTextbook) {
  SceneDef scene = empty_space();
  scene.world.gravity = {1, 0, -10};
  scene.boxes = {cube(1, {2, 5, 3}), cube(2, {0, 0, 9}), cube(3, {9, 0, 7})};
  scene.boxes[0].mass = 6;
  scene.boxes[0].velocity = {1, 2, 2};
  scene.boxes[0].spin = {2, 0, 0};
  scene.boxes[1].is_static = true;
  scene.boxes[2].frozen = true;
  const World world = made(scene);
  EXPECT_NEAR(kinetic_energy(world.bodies(), 0), 27 + 2, 1e-12);
  const sim::Energy energy = total_energy(world.state());
  EXPECT_NEAR(energy.kinetic, 29, 1e-12);
  EXPECT_NEAR(energy.potential, 6 * (30 - 2) + (70 - 9), 1e-9);
}

// 1 × 2 × 3 m, 12 kg: moments 13, 10, 5. A quarter turn about z lays the body's x along the world's y.
TEST(Energy, OfSpinUsesTheBodysOwnMoments) {
  SceneDef scene = empty_space();
  scene.boxes = {cube(1, {0, 0, 0})};
  scene.boxes[0].size = {1, 2, 3};
  scene.boxes[0].mass = 12;
  scene.boxes[0].orientation = turn({0, 0, 1}, 0, 1);
  scene.boxes[0].spin = {0, 2, 1};
  EXPECT_NEAR(kinetic_energy(made(scene).bodies(), 0), 0.5 * (13 * 4 + 5 * 1), 1e-9);
}

}  // namespace
}  // namespace tumble::test
