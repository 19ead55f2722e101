// What phases do to each body by itself: the same bits in lanes as by the functions for one body.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "src/kernels/kernels_by_width.h"
#include "src/layered/find/find_near_pairs.h"
#include "src/math/grid.h"
#include "src/thesis/integrate.h"
#include "src/world/body_check.h"
#include "src/world/free_flight.h"
#include "src/world/scratch.h"
#include "tests/support/sim_scenes.h"
#include "tumble/sim/step.h"

namespace tumble::sim {
namespace {

constexpr std::array<LaneWidth, 4> kWidths = {LaneWidth::kOne, LaneWidth::kTwo, LaneWidth::kFour, LaneWidth::kEight};
constexpr double kDt = 1.0 / 60;

// Bodies of every kind in no order: cubes and uneven boxes, frozen and static ones; 43 of them fill no vector evenly.
SceneDef mixed_bodies(std::uint64_t seed) {
  test::Random random(seed);
  SceneDef scene = test::on_ground();
  scene.world.method = Method::kLayered;
  scene.world.air_drag = seed % 2 == 0 ? 0 : 0.3;
  for (BodyId id = 1; id <= 43; ++id) {
    const auto number = [&](double most) { return random.uniform(-most, most); };
    const double size = random.uniform(0.2, 2);
    const bool even = random.uniform(0, 1) < 0.8;
    BoxDef box =
        test::box(id, even ? Vec3(size, size, size) : Vec3(size, 2 * size, 0.5), {number(9), number(9), number(9)});
    box.orientation = random.rotation();
    box.velocity = {number(20), number(20), number(20)};
    const double fastest = id % 3 == 0 ? 500 : 5;  // rad/s; both sides of the limit of half_turn
    box.spin = {number(fastest), number(fastest), number(fastest)};
    box.is_static = random.uniform(0, 1) < 0.1;
    scene.boxes.push_back(box);
  }
  return scene;
}

World world_in(const SceneDef& scene, LaneWidth width) {
  World world = *create_world(scene);
  world.mutable_scratch().lanes = width;
  Bodies& bodies = world.mutable_state().bodies;
  for (BodyIndex i = 0; i < bodies.size(); i += 5) bodies.frozen[i] = bodies.is_static[i] == 0 ? 1 : 0;
  return world;
}

TEST(BodyLanes, FlyAsOneBodyDoes) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    for (const LaneWidth width : kWidths) {
      if (!runs_lanes(width)) continue;
      World world = world_in(mixed_bodies(seed), width);
      Bodies expected = world.bodies();
      for (BodyIndex i = 0; i < expected.size(); ++i) {
        if (!expected.moves(i)) continue;
        const Flight flight = free_flight(world.state(), i, kDt);
        expected.position.set(i, flight.position);
        expected.orientation.set(i, flight.orientation);
        expected.velocity.set(i, flight.velocity);
        expected.spin.set(i, flight.spin);
      }
      ASSERT_NE(world.bodies(), expected);
      ASSERT_TRUE(test::run_phase(sim::integrate, world, kDt).ok());
      ASSERT_EQ(world.bodies(), expected) << name_of(width) << " lanes, seed " << seed;
    }
  }
}

// How much farther a body reaches to one side, m, if others hit it. with, without: m/s, its largest speed there if they
// do and if not.
double wider(double with, double without) { return PositionGrid::round(std::max(0.0, with - without) * kDt); }

// What find_near_pairs is to make of a body's AABB.
void expect_reach(const World& world, BodyIndex i) {
  const Bodies& bodies = world.bodies();
  const Scratch& scratch = world.scratch();
  const BoxFrame frame = {bodies.position[i], axes_of(bodies.orientation[i]), bodies.half_extent[i]};
  EXPECT_EQ(scratch.frames[i].position, frame.position);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(scratch.frames[i].axes[k], frame.axes[k]);
  EXPECT_EQ(scratch.frames[i].half_extent, frame.half_extent);
  const double turning = length(bodies.spin[i]) * length(frame.half_extent) * kDt;
  EXPECT_EQ(scratch.turning[i], turning);
  const double around = kContactSlack + falling_reach(world.state().def, kDt) + turning;
  const double margin = PositionGrid::round(around) + PositionGrid::kStep;
  const Vec3 path = PositionGrid::round(Vec3(bodies.velocity[i] * kDt));
  for (int k = 0; k < 3; ++k) {
    const double reach = PositionGrid::round(reach_along(frame, k)) + PositionGrid::kStep;
    const double v = bodies.moves(i) ? bodies.velocity[i][k] : 0;
    const VelocityRange range = scratch.ranges.empty() ? VelocityRange{} : scratch.ranges[i];
    const double low = wider(-range.low[k], std::max(0.0, -v)), high = wider(-range.opposite_high[k], std::max(0.0, v));
    EXPECT_EQ(scratch.aabb_low[i][k], frame.position[k] - reach - margin + std::min(path[k], 0.0) - low);
    EXPECT_EQ(scratch.aabb_high[i][k], frame.position[k] + reach + margin + std::max(path[k], 0.0) + high);
  }
}

TEST(BodyLanes, AreFramedAndReachOutAsOneBodyDoes) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    for (const LaneWidth width : kWidths) {
      if (!runs_lanes(width)) continue;
      SCOPED_TRACE(std::string(name_of(width)) + " lanes, seed " + std::to_string(seed));
      World world = world_in(mixed_bodies(seed), width);
      ASSERT_TRUE(test::run_phase(sim::find_near_pairs, world, kDt).ok());
      for (BodyIndex i = 0; i < world.bodies().size(); ++i) expect_reach(world, i);
      ASSERT_FALSE(testing::Test::HasFailure());
    }
  }
}

TEST(BodyLanes, NameTheFirstBodyThatIsWrong) {
  const SceneDef scene = mixed_bodies(2);
  const auto break_number = [](Bodies& bodies, BodyIndex i, int what) {
    if (what == 0) bodies.position.y[i] = -32769;
    if (what == 1) bodies.velocity.z[i] = std::nan("");
    if (what == 2) bodies.spin.x[i] = HUGE_VAL;
    if (what == 3) bodies.orientation.w[i] += 0.001;
  };
  for (BodyIndex i = 0; i < scene.boxes.size(); ++i) {
    World one = world_in(scene, LaneWidth::kOne);
    break_number(one.mutable_state().bodies, i, static_cast<int>(i % 4));
    const Status expected = one.bodies().moves(i) ? check_body(one.bodies(), i) : Status();
    ASSERT_EQ(expected.ok(), !one.bodies().moves(i));
    for (const LaneWidth width : kWidths) {
      if (!runs_lanes(width)) continue;
      World other = world_in(scene, width);
      break_number(other.mutable_state().bodies, i, static_cast<int>(i % 4));
      const Status found = check_moving(other.mutable_state().bodies, other.scratch().lanes);
      ASSERT_EQ(expected.ok(), found.ok()) << name_of(width) << " lanes, row " << i;
      if (found.ok()) continue;
      ASSERT_EQ(expected.error().message, found.error().message) << name_of(width);
    }
  }
}

}  // namespace
}  // namespace tumble::sim
