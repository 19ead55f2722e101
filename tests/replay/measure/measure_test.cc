// Metrics of small states whose answers are known by hand.
#include "replay/measure/measure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "replay/measure/measure_overlap.h"
#include "replay/measure/measure_state.h"
#include "tests/support/hand_states.h"
#include "tumble/sim/rotation.h"

namespace tumble::replay {
namespace {

using sim::BoxDef;
using sim::BoxFrame;
using sim::Quat;
using sim::Vec3;

Quat turned(const Vec3& axis, double degrees) {
  const double half = degrees * M_PI / 360;
  return {std::cos(half), axis.x() * std::sin(half), axis.y() * std::sin(half), axis.z() * std::sin(half)};
}

BoxFrame frame(const Vec3& position, const Quat& orientation = {}, const Vec3& half_extent = {0.5, 0.5, 0.5}) {
  return {position, sim::axes_of(orientation), half_extent};
}

TEST(MeasureOverlap, BoxesThatAreApartOrTouchDoNotOverlap) {
  EXPECT_EQ(overlap_depth(frame({0, 0, 0}), frame({1.5, 0, 0})), 0);
  EXPECT_EQ(overlap_depth(frame({0, 0, 0}), frame({1, 0.25, 0})), 0);
}

TEST(MeasureOverlap, ACrowdInOnePlaceIsMeasuredInNoTime) {
  constexpr std::size_t kCrowd = 100'000;  // 5·10⁹ pairs, minutes if each were looked at
  std::vector<BoxFrame> boxes(kCrowd, frame({1, 2, 3}));
  EXPECT_DOUBLE_EQ(deepest_overlap(boxes, std::vector<std::uint8_t>(kCrowd, 0)), 1);
}

TEST(MeasureOverlap, OfManyTurnedBoxesIsThatOfTheirDeepestPair) {
  std::vector<BoxFrame> boxes;
  for (int i = 0; i < 60; ++i) {
    const double d = i;
    boxes.push_back(frame({std::sin(3 * d), 1.5 * std::sin(5 * d), std::sin(7 * d)}, turned({0, 0.6, 0.8}, 37 * d),
                          {0.2 + 0.1 * (i % 3), 0.3, 0.2 + 0.05 * (i % 5)}));
  }
  double deepest = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) deepest = std::max(deepest, overlap_depth(boxes[i], boxes[j]));
  }
  EXPECT_GT(deepest, 0.25);
  EXPECT_NEAR(deepest_overlap(boxes, std::vector<std::uint8_t>(boxes.size(), 0)), deepest, 1e-14);
}

TEST(MeasureOverlap, IsTheShortestWayApart) {
  EXPECT_DOUBLE_EQ(overlap_depth(frame({0, 0, 0}), frame({0.75, 0.5, 0})), 0.25);
  EXPECT_DOUBLE_EQ(overlap_depth(frame({0, 0, 0}), frame({0, 0, 0})), 1) << "coincident boxes";
  EXPECT_DOUBLE_EQ(overlap_depth(frame({0, 0, 0}), frame({0, 0, 0}, {}, {2, 2, 0.05})), 0.55) << "a plate inside";
  // A corner turned towards a face: half the diagonal reaches √½ far.
  EXPECT_NEAR(overlap_depth(frame({0, 0, 0}), frame({1.1, 0, 0}, turned({0, 0, 1}, 45))), 0.5 + std::sqrt(0.5) - 1.1,
              1e-12);
}

TEST(MeasureOverlap, CrossedEdgesAreKeptApartByTheirCrossProduct) {
  // Two cubes, each with an edge towards the other, at right angles: only the edges' common normal (z) separates them.
  const Quat about_x = turned({1, 0, 0}, 45), about_y = turned({0, 1, 0}, 45);
  EXPECT_EQ(overlap_depth(frame({0, 0, 0}, about_x), frame({0, 0, 1.42}, about_y)), 0);
  EXPECT_NEAR(overlap_depth(frame({0, 0, 0}, about_x), frame({0, 0, 1.40}, about_y)), 2 * std::sqrt(0.5) - 1.40, 1e-12);
}

TEST(MeasureOverlap, FindsTheDeepestPairOfManyAndSkipsStatics) {
  std::vector<BoxFrame> boxes;
  boxes.reserve(200);
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 20; ++x) boxes.push_back(frame({2.0 * x, 2.0 * y, 0.5}));
  }
  std::vector<std::uint8_t> is_static(boxes.size(), 0);
  EXPECT_EQ(deepest_overlap(boxes, is_static), 0);
  boxes[150].position = boxes[151].position - Vec3(0.75, 0, 0);
  boxes[17].position = boxes[18].position - Vec3(0.875, 0, 0);
  EXPECT_DOUBLE_EQ(deepest_overlap(boxes, is_static), 0.25);
  is_static[150] = is_static[151] = 1;
  EXPECT_DOUBLE_EQ(deepest_overlap(boxes, is_static), 0.125);
}

TEST(MeasureOverlap, GroundPenetrationIsTheLowestCorners) {
  EXPECT_EQ(ground_penetration(frame({0, 0, 0.5})), 0);
  EXPECT_DOUBLE_EQ(ground_penetration(frame({0, 0, 0.25})), 0.25);
  EXPECT_NEAR(ground_penetration(frame({0, 0, 0.7}, turned({1, 0, 0}, 45))), std::sqrt(0.5) - 0.7, 1e-12);
}

TEST(MeasureState, MovesAreThoseOfDynamicBodiesOfTheStart) {
  std::vector<BoxDef> boxes = {box(1, {0, 0, 2}), box(2, {5, 0, 2}), box(3, {9, 0, 2})};
  boxes[2].is_static = true;
  StateMeter meter(scene_of(boxes), states_of(boxes));
  meter.apply(sim::Throw{box(4, {100, 0, 2})});
  std::vector<BoxDef> now = {box(1, {-3, 4, 1.5}), box(3, {50, 50, 0}), box(4, {-900, 0, 2})};
  const StateMeasures measures = meter.measure(states_of(now));
  EXPECT_EQ(measures.lateral_max, 3);
  EXPECT_EQ(measures.lateral_rms, 3);
  EXPECT_EQ(measures.drift_max, 5);
  EXPECT_EQ(measures.top_drop_max, 0.5);
  EXPECT_FALSE(measures.column_spread);
}

TEST(MeasureState, TiltIgnoresTurnsAboutTheVertical) {
  std::vector<BoxDef> boxes = {box(1, {0, 0, 2})};
  boxes[0].orientation = turned({1, 0, 0}, 45);
  StateMeter meter(scene_of(boxes), states_of(boxes));
  EXPECT_EQ(meter.measure(states_of(boxes)).tilt_max, 0);
  std::vector<BoxDef> now = boxes;
  now[0].orientation = sim::product(turned({0, 0, 1}, 70), boxes[0].orientation);
  EXPECT_NEAR(meter.measure(states_of(now)).tilt_max, 0, 1e-12);
  now[0].orientation = sim::product(turned({0, 1, 0}, 30), boxes[0].orientation);
  EXPECT_NEAR(meter.measure(states_of(now)).tilt_max, 30, 1e-12);
}

TEST(MeasureState, ColumnSpreadIsTheWidestRowOfAnyGrid) {
  std::vector<BoxDef> boxes;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t row = i / 2, column = i % 2;
    boxes.push_back(box(i + 1, {2.0 * column, 2.0 * row, 1}));
    boxes.back().origin = {sim::Origin::Kind::kGrid, 0, row, column};
  }
  StateMeter meter(scene_of(boxes), states_of(boxes));
  EXPECT_EQ(meter.measure(states_of(boxes)).column_spread, 0);
  std::vector<BoxDef> now = boxes;
  now[3].position.z() = 1.25;
  now[1].position.y() = -0.125;
  EXPECT_EQ(meter.measure(states_of(now)).column_spread, 0.25);
  now.pop_back();  // removed bodies do not count
  EXPECT_EQ(meter.measure(states_of(now)).column_spread, 0.125);
}

TEST(MeasureState, BodiesOnceUnderTheGroundStayLost) {
  const std::vector<BoxDef> boxes = {box(1, {0, 0, 1}), box(2, {5, 0, 1})};
  StateMeter meter(scene_of(boxes), states_of(boxes));
  for (int twice = 0; twice < 2; ++twice) {
    static_cast<void>(meter.measure(states_of({box(1, {0, 0, -0.25}), box(2, {5, 0, 1})})));
  }
  static_cast<void>(meter.measure(states_of(boxes)));
  EXPECT_EQ(meter.lost(), 1U);
}

// A box of 1 kg at 2.5 m under 10 m/s²: 25 J, of which 20 J lie above its rest on the ground.
class MeasureSession : public testing::Test {
 protected:
  MeasureSession() {
    header_.scene = scene_of({start_});
    moving_.velocity = {1, 0, 0};
    start_record_.has_states = true;
    start_record_.states = states_of({start_});
  }

  LogHeader header_;
  BoxDef start_ = box(1, {0, 0, 2.5});
  BoxDef moving_ = start_;
  StepRecord start_record_;
};

TEST_F(MeasureSession, GainIsOverTheRunningMinimumWithoutTheWorkOfInputs) {
  Measurer measurer(header_);
  measurer.add(start_record_);
  measurer.add(step_record(1, {moving_}, 2, 21));            // 23: lost 2
  measurer.add(step_record(2, {moving_}, 4, 21));            // 25: gained 2, though no more than at the start
  measurer.add(step_record(3, {moving_}, 50, 21, 45, 0.5));  // an input put in 45: 26 without it
  measurer.add(step_record(4, {moving_}, 40, 21));           // 16
  const Metrics metrics = *measurer.finish(states_of({moving_}));
  EXPECT_EQ(metrics.steps, 4U);
  EXPECT_EQ(metrics.energy.initial, 25);
  EXPECT_EQ(metrics.energy.final, 61);
  EXPECT_EQ(metrics.energy.gain_max, 3);
  EXPECT_EQ(metrics.energy.gain_ratio, 3.0 / 20);
  EXPECT_EQ(metrics.energy.inputs, 45);
  EXPECT_EQ(metrics.energy.removed, 0.5);
  EXPECT_EQ(metrics.stacking.kinetic_end(), 0.5) << "of the states, not of what the log counted";
}

TEST_F(MeasureSession, RestCountsFromTheLastTimeItBegan) {
  BoxDef frozen = start_;
  frozen.frozen = true;
  Measurer measurer(header_);
  measurer.add(start_record_);
  measurer.add(step_record(1, {start_}, 0, 25));
  measurer.add(step_record(2, {moving_}, 0.5, 25));
  measurer.add(step_record(3, {start_}, 0, 25));
  measurer.add(step_record(4, {frozen}, 0, 25));
  const Metrics rested = *measurer.finish(states_of({frozen}));
  EXPECT_EQ(rested.stacking.rest_time, 0.75);
  EXPECT_EQ(rested.stacking.frozen_fraction, 1);
  measurer.add(step_record(5, {moving_}, 0.5, 25));
  EXPECT_FALSE(measurer.finish(states_of({moving_}))->stacking.rest_time);
}

TEST_F(MeasureSession, ThrownBodiesCountFromTheStepTheyAppear) {
  Measurer measurer(header_);
  measurer.add(start_record_);
  BoxDef thrown = box(7, {5, 0, 9});
  thrown.velocity = {0, 3, 0};
  StepRecord record = step_record(1, {start_, thrown}, 4.5, 115, 94.5);
  record.inputs.emplace_back(sim::Throw{thrown});
  measurer.add(record);
  EXPECT_EQ(measurer.row().state.kinetic_linear, 4.5);
  const Metrics metrics = *measurer.finish(record.states);
  EXPECT_EQ(metrics.bodies, 2U);
  EXPECT_EQ(metrics.energy.gain_max, 0);
  EXPECT_EQ(metrics.stacking.drift_max, 0);
  EXPECT_FALSE(metrics.stacking.rest_time);
}

}  // namespace
}  // namespace tumble::replay
