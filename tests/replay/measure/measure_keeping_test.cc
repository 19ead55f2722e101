// Metrics over all steps of a session: bounces, free rotation, lost bodies, the deepest overlap.
#include <gtest/gtest.h>

#include <cmath>

#include "replay/measure/body_track.h"
#include "replay/measure/measure.h"
#include "replay/measure/reasonable_space.h"
#include "tests/support/hand_states.h"
#include "tumble/sim/step.h"

namespace tumble::replay {
namespace {

using sim::Vec3;

constexpr double kPull = 10;

// A body that is dropped from a height and rises to other heights, one after the other, sampled every dt seconds.
BodyTrack bouncing(const std::vector<double>& tops, double dt) {
  BodyTrack track;
  double phase = 0;  // s into the flight
  for (std::size_t i = 0; i < tops.size(); ++i) {
    const double fall = std::sqrt(2 * tops[i] / kPull);
    const double end = i == 0 ? fall : 2 * fall;
    const double speed = i == 0 ? 0 : kPull * fall;  // at the start of the flight
    const double height = i == 0 ? tops[0] : 0;
    for (; phase < end; phase += dt) {
      track.add({.height = height + speed * phase - kPull / 2 * phase * phase,
                 .rise = speed - kPull * phase,
                 .spin_momentum = Vec3::Zero()},
                kPull);
    }
    phase -= end;
  }
  return track;
}

TEST(BodyTrack, BounceHeightsAreComparedWithTheFirstHoweverTheStepsFall) {
  for (const double dt : {1.0 / 300, 1.0 / 60, 0.037}) {
    EXPECT_NEAR(*bouncing({2, 2, 2, 2}, dt).bounce_height_loss(), 0, 1e-12) << dt;
    const BodyTrack sagging = bouncing({2, 1.9, 1.5, 1.8}, dt);
    EXPECT_NEAR(*sagging.bounce_height_loss(), 0.25, 1e-12) << dt;
    EXPECT_EQ(sagging.bounces(), 3U) << dt;
    EXPECT_NEAR(*bouncing({2, 2.2}, dt).bounce_height_loss(), 0.1, 1e-12) << "a gain counts too";
  }
}

TEST(BodyTrack, TheTopOfTheFirstFlightIsNoBounce) {
  BodyTrack track;
  for (double t = 0; t < 1; t += 0.125) {
    track.add({.height = 1 + 4 * t - 5 * t * t, .rise = 4 - 10 * t, .spin_momentum = Vec3::Zero()}, kPull);
  }
  EXPECT_EQ(track.bounces(), 0U);
  EXPECT_FALSE(track.bounce_height_loss());
}

TEST(BodyTrack, WithoutGravityNothingBounces) {
  BodyTrack track;
  for (const double rise : {-1.0, 1.0, -1.0, 1.0, -1.0}) {
    track.add({.height = 2, .rise = rise, .spin_momentum = Vec3::Zero()}, 0);
  }
  EXPECT_EQ(track.bounces(), 0U);
}

TEST(BodyTrack, SpinIsComparedWithTheFirstAndWithItsLeastEnergy) {
  BodyTrack track;
  track.add({.spin_momentum = {0, 0, 2}, .spin_energy = 4}, kPull);
  track.add({.spin_momentum = {0, 0.5, 2}, .spin_energy = 2}, kPull);
  track.add({.spin_momentum = {0, 0, 2.25}, .spin_energy = 3}, kPull);
  EXPECT_DOUBLE_EQ(*track.momentum_drift(), 0.25);
  EXPECT_DOUBLE_EQ(*track.spin_energy_gain(), 0.25) << "1 J over the least, of 4 J";
  BodyTrack still;
  still.add({.spin_momentum = Vec3::Zero()}, kPull);
  EXPECT_FALSE(still.momentum_drift());
  EXPECT_FALSE(still.spin_energy_gain());
}

// The meter measures momentum in the world's axes, where a plate that rotates freely about none of its own axes keeps
// it.
TEST(MeasureKeeping, FreeSpinKeepsItsAngularMomentum) {
  BoxDef plate = box(1, {0, 0, 0});
  plate.size = {1, 2, 0.25};
  plate.spin = {1, 0.5, 2};
  sim::SceneDef scene = scene_of({plate});
  scene.world.ground = scene.world.freezing = false;
  scene.world.gravity = Vec3::Zero();
  Result<sim::World> world = sim::create_world(scene);
  ASSERT_TRUE(world.ok());
  BodyStates states;
  copy_visible(world->bodies(), states);
  StateMeter meter(scene, states);
  for (int k = 0; k < 120; ++k) {
    ASSERT_TRUE(sim::step(*world).ok());
    copy_visible(world->bodies(), states);
    static_cast<void>(meter.measure(states));
  }
  EXPECT_LT(*meter.keeping().momentum_drift, 1e-9);
  EXPECT_LE(*meter.keeping().spin_energy_gain, 1e-9);
  EXPECT_GT((states.spin[0] - plate.spin).norm(), 0.1) << "the spin itself has moved, or this shows nothing";
}

TEST(MeasureKeeping, OverlapAndPenetrationHaveAPeakOverTime) {
  const std::vector<BoxDef> apart = {box(1, {0, 0, 0.5}), box(2, {3, 0, 0.5})};
  const std::vector<BoxDef> deep = {box(1, {0, 0, 0.25}), box(2, {0.75, 0, 0.5})};
  LogHeader header;
  header.scene = scene_of(apart);
  MeasureOptions options;
  options.overlap_every = 2;
  for (const std::uint64_t when : {1U, 2U}) {
    Measurer measurer(header, options);
    measurer.add(step_record(0, apart));
    for (std::uint64_t k = 1; k <= 3; ++k) measurer.add(step_record(k, k == when ? deep : apart));
    const Metrics metrics = *measurer.finish(states_of(apart));
    EXPECT_EQ(metrics.stacking.overlap_max, 0);
    EXPECT_EQ(metrics.stacking.overlap_peak, when == 2 ? 0.25 : 0) << "looked at in every second step";
    EXPECT_EQ(metrics.stacking.ground_penetration_max, 0);
    EXPECT_EQ(metrics.stacking.ground_penetration_peak, 0.25);
  }
}

TEST(MeasureKeeping, KineticEnergyIsLinearAndRotational) {
  BoxDef moving = box(1, {0, 0, 2});
  moving.size = {1, 2, 3};
  moving.mass = 12;
  moving.velocity = {0, 2, 0};
  moving.spin = {0, 0, 2};
  StateMeter meter(scene_of({moving}), states_of({moving}));
  const StateMeasures measures = meter.measure(states_of({moving}));
  EXPECT_DOUBLE_EQ(measures.kinetic_linear, 24);
  EXPECT_DOUBLE_EQ(measures.kinetic_rotational, 10) << "12/12 (1² + 2²) = 5 kg·m² at 2 rad/s";
}

TEST(ReasonableSpace, EndsAtTheGround) {
  ReasonableSpace space(true);
  space.add(box(1, {0, 0, 1}));
  EXPECT_TRUE(space.holds({0, 0, 0}, 0));
  EXPECT_FALSE(space.holds({0, 0, -0.001}, 0));
}

TEST(ReasonableSpace, WithoutGroundEndsBelowTheLowestStaticBox) {
  ReasonableSpace space(false);
  space.add(box(1, {0, 0, 1}));
  EXPECT_TRUE(space.holds({0, 0, -900}, 0)) << "nothing to fall through";
  for (const double z : {-3.0, -2.0}) {
    BoxDef floor = box(2, {0, 0, z});
    floor.is_static = true;
    space.add(floor);
  }
  EXPECT_TRUE(space.holds({0, 0, -3.25}, 0));
  EXPECT_FALSE(space.holds({0, 0, -3.75}, 0));
}

TEST(ReasonableSpace, EndsFarFromWhereBodiesBegan) {
  ReasonableSpace space(true);
  space.add(box(1, {-5, 0, 1}));
  space.add(box(2, {5, 0, 1}));
  EXPECT_TRUE(space.holds({1005, 0, 1}, 0));
  EXPECT_FALSE(space.holds({1006, 0, 1}, 0));
  EXPECT_FALSE(space.holds({0, -1001, 1}, 0));
  EXPECT_FALSE(space.holds({0, 0, 1002}, 0));
}

// What belongs far away is not lost there: a scene of 5 km has room of its own size, and a shot has its way.
TEST(ReasonableSpace, ReachesAsFarAsTheSceneIsWideAndAsBodiesAreSent) {
  ReasonableSpace wide(true);
  wide.add(box(1, {0, 0, 1}));
  wide.add(box(2, {5000, 0, 1}));
  EXPECT_TRUE(wide.holds({2500, 4900, 1}, 0));
  EXPECT_TRUE(wide.holds({2500, 0, 3000}, 0));
  EXPECT_FALSE(wide.holds({2500, 5100, 1}, 0));
  ReasonableSpace shot(true);
  shot.add(box(1, {0, 0, 1}));
  EXPECT_TRUE(shot.holds({0, 0, 1990}, 1000));
  EXPECT_FALSE(shot.holds({0, 0, 2010}, 1000));
}

// What falls from a height lies where it belongs, and gravity to a side takes bodies to that side alone.
TEST(ReasonableSpace, ReachesAsFarAsGravityTakesBodies) {
  ReasonableSpace high(true);
  high.add(box(1, {0, 0, 3000}));
  EXPECT_TRUE(high.holds({0, 0, 0.5}, 0)) << "3000 m high, and nothing fell yet";
  ReasonableSpace fall(true);
  fall.add(box(1, {0, 0, 44.5}));  // its top at 45 m
  for (int k = 0; k < 100; ++k) fall.pass(1, {0, 0, -10});
  EXPECT_TRUE(fall.holds({0, 3950, 0.5}, 0)) << "30 m/s of the fall";
  EXPECT_FALSE(fall.holds({0, 4050, 0.5}, 0));
  EXPECT_FALSE(fall.holds({0, 0, 1100}, 0)) << "nothing falls upwards";
  ReasonableSpace slide(true);
  slide.add(box(1, {0, 0, 0}));
  for (int k = 0; k < 1000; ++k) slide.pass(0.04, {3, 0, 0});
  EXPECT_TRUE(slide.holds({3390, 0, 0}, 0)) << "½ 3 40² = 2400";
  EXPECT_FALSE(slide.holds({3410, 0, 0}, 0));
  EXPECT_FALSE(slide.holds({-1010, 0, 0}, 0));
  EXPECT_FALSE(slide.holds({0, 1010, 0}, 0));
}

// The speeds that inputs give count from then on; pushes of one body add up.
TEST(MeasureKeeping, ABodyThatInputsSendFarIsNotLost) {
  const auto lost = [](const std::vector<sim::Command>& inputs) {
    const BoxDef start = box(1, {0, 0, 1});
    BoxDef far = start;
    far.position = {0, 1500, 1};
    StateMeter meter(scene_of({start}), states_of({start}));
    static_cast<void>(meter.measure(states_of({start})));
    for (const sim::Command& input : inputs) meter.apply(input);
    static_cast<void>(meter.measure(states_of({far}), 1, 1));
    return meter.lost();
  };
  EXPECT_EQ(lost({}), 1U);
  EXPECT_EQ(lost({sim::SetVelocity{1, {0, 600, 0}, {0, 0, 0}}}), 0U);
  EXPECT_EQ(lost({sim::SetVelocity{1, {0, 400, 0}, {0, 0, 0}}}), 1U);
  const double mass = box(1, {0, 0, 1}).mass;
  const sim::Push push = {1, {0, 300 * mass, 0}};
  EXPECT_EQ(lost({push}), 1U);
  EXPECT_EQ(lost({push, push}), 0U);
}

// A heavy body gives a light one at most twice its speed; what a light one was given moves no heavy one.
TEST(MeasureKeeping, AHitReachesAsFarAsTheOtherBodysMassTakesIt) {
  const auto lost = [](double mass, double way) {
    std::vector<BoxDef> boxes = {box(1, {0, 0, 1}), box(2, {5, 0, 1})};
    boxes[0].mass = mass;
    boxes[1].mass = 1;
    boxes[0].velocity = {150, 0, 0};
    StateMeter meter(scene_of(boxes), states_of(boxes));
    boxes[1].position.x() = way;
    static_cast<void>(meter.measure(states_of(boxes), 1, 10));
    return meter.lost();
  };
  EXPECT_EQ(lost(1000, 3900), 0U) << "1000 m and ten seconds of 299.7 m/s";
  EXPECT_EQ(lost(1000, 4100), 1U);
  EXPECT_EQ(lost(1e-6, 900), 0U);
  EXPECT_EQ(lost(1e-6, 1100), 1U);
}

// A car of another engine, whose motor is no input, drives as far as it likes; what an engine shoots away is lost.
TEST(MeasureKeeping, OnlyWhatGainsSpeedStepByStepIsDriven) {
  const auto lost = [](bool told, double gain) {
    std::vector<BoxDef> boxes = {box(1, {0, 0, 1})};
    StateMeter meter(scene_of(boxes), states_of(boxes));
    if (told) meter.take_told_speeds();
    for (std::uint64_t step = 1; step <= 300; ++step) {
      boxes[0].velocity.x() = std::min(100.0, static_cast<double>(step) * gain);
      boxes[0].position.x() += boxes[0].velocity.x() * 0.1;
      static_cast<void>(meter.measure(states_of(boxes), step, 0.1));
    }
    return meter.lost();
  };
  EXPECT_EQ(lost(true, 5), 0U);
  EXPECT_EQ(lost(true, 100), 1U);
  EXPECT_EQ(lost(false, 5), 1U) << "this program tells all that drives a body";
}

TEST(MeasureKeeping, ABodyThatVanishesIsLostUnlessAnInputTookIt) {
  const std::vector<BoxDef> both = {box(1, {0, 0, 1}), box(2, {5, 0, 1})};
  for (const bool asked : {false, true}) {
    StateMeter meter(scene_of(both), states_of(both));
    static_cast<void>(meter.measure(states_of(both)));
    if (asked) meter.apply(sim::Remove{2});
    static_cast<void>(meter.measure(states_of({both[0]})));
    EXPECT_EQ(meter.lost(), asked ? 0U : 1U);
  }
}

// The table of an engine may lack a body for a while.
TEST(MeasureKeeping, ABodyThatComesBackIsTheOneThatWasThere) {
  std::vector<BoxDef> both = {box(1, {0, 0, 1}), box(2, {5, 0, 1})};
  StateMeter meter(scene_of(both), states_of(both));
  const auto bounce_of_both = [&] {
    for (const double rise : {-1, 1, -1, 1}) {
      for (BoxDef& one : both) one.velocity.z() = rise;
      static_cast<void>(meter.measure(states_of(both), 1, 0.1));
    }
  };
  meter.apply(sim::Remove{2});
  static_cast<void>(meter.measure(states_of({both[0]})));
  meter.apply(sim::Throw{both[1]});
  bounce_of_both();
  EXPECT_GT(meter.keeping().bounces, 0U) << "of both: no third body that never bounces is counted";
  static_cast<void>(meter.measure(states_of({both[0]})));
  EXPECT_EQ(meter.lost(), 1U) << "no input took it this time";
}

TEST(MeasureKeeping, AnotherBodyOfAnIdIsMeasuredAsItself) {
  const BoxDef start = box(1, {0, 0, 0.5});
  BoxDef small = start;
  small.size = {0.2, 0.2, 0.2};
  small.position.z() = 0.1;
  StateMeter meter(scene_of({start}), states_of({start}));
  static_cast<void>(meter.measure(states_of({start})));
  meter.apply(sim::Remove{1});
  meter.apply(sim::Throw{small});
  const StateMeasures measures = meter.measure(states_of({small}));
  EXPECT_EQ(measures.ground_penetration_max, 0);
  EXPECT_EQ(measures.of_start, 0U);
}

}  // namespace
}  // namespace tumble::replay
