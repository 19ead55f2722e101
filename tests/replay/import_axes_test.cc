// Axes of other engines and ours: exact both ways, and up stays up.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <string>

#include "tests/replay/imported_table.h"
#include "tumble/replay/imported_table.h"

namespace tumble::replay {
namespace {

TEST(ImportAxes, TheyConvertBackToTheBit) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  const sim::Vec3 v = {0.1, -0.0, -0.3};
  for (const bool left : {false, true}) {
    for (const int up : {0, 1, 2}) {
      const EngineAxes axes = {up, left, 1};
      const sim::Vec3 there = axes.their_length(axes.length(v)), spun = axes.their_axial(axes.axial(v));
      const sim::Quat q = axes.their_turn(axes.turn({0.5, v.x(), v.y(), v.z()}));
      for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(bits(there[k]), bits(v[k])) << to_string(axes);
        EXPECT_EQ(bits(spun[k]), bits(v[k])) << to_string(axes);
        const EngineAxis axis = axes.along(k);
        EXPECT_EQ(axes.length(v)[k], axis.sign * v[axis.letter - 'x']) << to_string(axes);
        const EngineAxis about = axes.axial_along(k);
        EXPECT_EQ(axes.axial(v)[k], about.sign * v[about.letter - 'x']) << to_string(axes);
      }
      EXPECT_EQ(bits(q.x), bits(v.x())) << to_string(axes);
    }
  }
}

TEST(ImportAxes, UpStaysUpOfEitherHand) {
  for (const bool left : {false, true}) {
    for (const int up : {0, 1, 2}) {
      const EngineAxes axes = {up, left, 0.01};
      sim::Vec3 v = {0, 0, 0};
      v[up] = 100;
      EXPECT_EQ(axes.length(v), sim::Vec3(0, 0, 1)) << to_string(axes);
      EXPECT_EQ(axes.along(2).letter, "xyz"[up]) << to_string(axes);
      EXPECT_EQ(axes.along(2).sign, 1) << to_string(axes);
      const sim::Vec3 i = axes.direction({1, 0, 0}), j = axes.direction({0, 1, 0}), k = axes.direction({0, 0, 1});
      EXPECT_EQ(sim::dot(sim::cross(i, j), k), left ? -1 : 1) << to_string(axes);
    }
  }
  Result<LogReader> unreal = import(std::string("# dt: 0.1\n# up: z\n# handed: left\n# length: cm\nstep,id,") + kPose +
                                    kMotion + "\n0,1,100,200,300,0.4,0.2,0.4,0.8,1,2,3,4,5,6\n");
  ASSERT_TRUE(unreal.ok()) << unreal.error().message;
  EXPECT_EQ(unreal->header().scene.world.gravity, sim::Vec3(0, 0, -9.81)) << "of a table that does not tell it";
  const BodyStates states = (*unreal->read_step(0))->states;
  EXPECT_EQ(states.position[0], sim::Vec3(1, -2, 3));
  EXPECT_EQ(states.spin[0], sim::Vec3(-4, 5, -6));
  EXPECT_EQ(states.orientation[0], (sim::Quat{0.4, -0.2, 0.4, -0.8}));
}

}  // namespace
}  // namespace tumble::replay
