// Mirrored pairs: an error of 0 where the pair is exact, and the distance where it is not.
#include "replay/measure/mirrored_pair.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/hand_states.h"
#include "tests/support/log_memory.h"
#include "tests/support/sim_scenes.h"
#include "tests/support/transforms.h"

namespace tumble::replay {
namespace {

using test::all_transforms;

sim::SceneDef falling_heap(sim::Method method) {
  sim::SceneDef scene = test::tumble_of_boxes(2, 5);
  test::add_thrown_cube(scene);
  scene.world.method = method;
  scene.steps = 60;
  return scene;
}

TEST(MirroredPair, StaysExact) {
  for (const sim::Method method : kMethods) {
    for (const sim::Transform& transform : all_transforms()) {
      const Result<PairReport> report = run_mirrored_pair(falling_heap(method), transform);
      ASSERT_TRUE(report.ok()) << report.error().message;
      EXPECT_EQ(report->error, 0) << to_string(transform);
      EXPECT_EQ(report->differing, 0U) << to_string(transform);
      EXPECT_EQ(report->steps, 60U);
    }
  }
}

// Inputs that name bodies, points and directions must be transformed too.
TEST(MirroredPair, InputsAreTransformedToo) {
  for (const sim::Transform& transform : all_transforms()) {
    const Result<PairReport> report = run_mirrored_pair(scene_with_inputs(), transform);
    ASSERT_TRUE(report.ok()) << report.error().message;
    EXPECT_EQ(report->differing, 0U) << to_string(transform);
  }
}

TEST(PairMeter, SaysHowFarAndSinceWhen) {
  PairMeter meter({.mirror_x = true}, {});
  meter.add(0, states_of({box(1, {1, 2, 3})}), states_of({box(1, {-1, 2, 3})}));
  EXPECT_FALSE(meter.report().first_step);
  meter.add(1, states_of({box(1, {1, 2, 3})}), states_of({box(1, {-4, 6, 3})}));
  meter.add(2, states_of({box(1, {1, 2, 3})}), states_of({box(1, {-1, 2.5, 3})}));
  EXPECT_EQ(meter.report().error, 5);
  EXPECT_EQ(meter.report().first_step, 1U);
  EXPECT_EQ(meter.report().differing, 1U);
}

TEST(PairMeter, ASpinOfTheWrongSenseIsADifference) {
  BoxDef from = box(1, {1, 2, 3}), to = box(1, {-1, 2, 3});
  from.spin = to.spin = {1, 2, 3};
  PairMeter meter({.mirror_x = true}, {});
  meter.add(1, states_of({from}), states_of({to}));
  EXPECT_EQ(meter.report().differing, 1U);
  EXPECT_EQ(meter.report().error, 0) << "its place is right";
}

TEST(PairMeter, BodiesWithoutAPartnerCountTheWidthOfTheWorld) {
  for (const bool in_second : {false, true}) {
    const BodyStates one = states_of({box(1, {0, 0, 0})}), two = states_of({box(1, {0, 0, 0}), box(2, {5, 0, 0})});
    PairMeter meter({}, {});
    meter.add(1, in_second ? one : two, in_second ? two : one);
    EXPECT_EQ(meter.report().error, kNoPartner);
    EXPECT_EQ(meter.report().differing, 1U);
  }
}

Result<PairReport> compare(const Bytes& original, const Bytes& transformed) {
  Result<LogReader> a = open_memory(original), b = open_memory(transformed);
  return compare_mirrored_pair(*a, *b);
}

TEST(MirroredLogs, CarryTheirTransform) {
  const sim::SceneDef scene = falling_heap(sim::Method::kThesis);
  RecordOptions sparse;
  sparse.states.every = 7;
  const Bytes original = record_to_memory(scene, sparse);
  for (const sim::Transform& transform : all_transforms()) {
    RecordOptions options;
    options.transform = transform;
    const Bytes transformed = record_to_memory(scene, options);
    EXPECT_EQ(open_memory(transformed)->header().transform, transform);
    const Result<PairReport> report = compare(original, transformed);
    ASSERT_TRUE(report.ok()) << report.error().message;
    EXPECT_EQ(report->differing, 0U) << to_string(transform);
    EXPECT_EQ(report->steps, 60U);
  }
}

TEST(MirroredLogs, OfOtherScenesOrLengthsAreRefused) {
  const sim::SceneDef scene = falling_heap(sim::Method::kThesis);
  sim::SceneDef other = scene, shorter = scene;
  other.boxes[3].mass *= 2;
  shorter.steps = 59;
  RecordOptions mirrored;
  mirrored.transform.mirror_y = true;
  const Bytes original = record_to_memory(scene), transformed = record_to_memory(scene, mirrored);
  EXPECT_NE(compare(record_to_memory(other), transformed).error().message.find("another box"), std::string::npos);
  EXPECT_NE(compare(original, record_to_memory(shorter, mirrored)).error().message.find("found 59 steps"),
            std::string::npos);
  EXPECT_NE(compare(transformed, transformed).error().message.find("wanted the original"), std::string::npos);
}

TEST(MirroredPair, ErrorsGoToTheMetricOfTheirKind) {
  PairReport report;
  report.error = 0.5;
  SymmetryMetrics mirror, order, shift;
  set_pair_error({.swap_xy = true}, report, mirror);
  set_pair_error({.permute = 3}, report, order);
  set_pair_error({.shift = {1, 0, 0}}, report, shift);
  EXPECT_EQ(mirror.mirror_error, 0.5);
  EXPECT_FALSE(mirror.order_error || mirror.shift_error);
  EXPECT_EQ(order.order_error, 0.5);
  EXPECT_FALSE(order.mirror_error || order.shift_error);
  EXPECT_EQ(shift.shift_error, 0.5);
}

}  // namespace
}  // namespace tumble::replay
