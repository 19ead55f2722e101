// Sessions and their images: 0 where they are exact, and the distance where they are not.
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

TEST(Twin, ASceneAndItsImageStayAlike) {
  for (const sim::Method method : kMethods) {
    for (const sim::Transform& transform : all_transforms()) {
      const Result<TwinReport> report = run_twins(falling_heap(method), transform);
      ASSERT_TRUE(report.ok()) << report.error().message;
      EXPECT_EQ(report->error, 0) << to_string(transform);
      EXPECT_EQ(report->differing, 0U) << to_string(transform);
      EXPECT_EQ(report->steps, 60U);
    }
  }
}

// Inputs that name bodies, points and directions must be transformed too.
TEST(Twin, InputsAreTransformedToo) {
  for (const sim::Transform& transform : all_transforms()) {
    const Result<TwinReport> report = run_twins(scene_with_inputs(), transform);
    ASSERT_TRUE(report.ok()) << report.error().message;
    EXPECT_EQ(report->differing, 0U) << to_string(transform);
  }
}

TEST(TwinMeter, SaysHowFarAndSinceWhen) {
  TwinMeter meter({.mirror_x = true}, {});
  meter.add(0, states_of({box(1, {1, 2, 3})}), states_of({box(1, {-1, 2, 3})}));
  EXPECT_FALSE(meter.report().first_step);
  meter.add(1, states_of({box(1, {1, 2, 3})}), states_of({box(1, {-4, 6, 3})}));
  meter.add(2, states_of({box(1, {1, 2, 3})}), states_of({box(1, {-1, 2.5, 3})}));
  EXPECT_EQ(meter.report().error, 5);
  EXPECT_EQ(meter.report().first_step, 1U);
  EXPECT_EQ(meter.report().differing, 1U);
}

TEST(TwinMeter, ASpinOfTheWrongSenseIsADifference) {
  BoxDef from = box(1, {1, 2, 3}), to = box(1, {-1, 2, 3});
  from.spin = to.spin = {1, 2, 3};
  TwinMeter meter({.mirror_x = true}, {});
  meter.add(1, states_of({from}), states_of({to}));
  EXPECT_EQ(meter.report().differing, 1U);
  EXPECT_EQ(meter.report().error, 0) << "its place is right";
}

TEST(TwinMeter, BodiesWithoutATwinCountTheWidthOfTheWorld) {
  for (const bool in_image : {false, true}) {
    const BodyStates one = states_of({box(1, {0, 0, 0})}), two = states_of({box(1, {0, 0, 0}), box(2, {5, 0, 0})});
    TwinMeter meter({}, {});
    meter.add(1, in_image ? one : two, in_image ? two : one);
    EXPECT_EQ(meter.report().error, kNoTwin);
    EXPECT_EQ(meter.report().differing, 1U);
  }
}

Result<TwinReport> compare(const Bytes& original, const Bytes& image) {
  Result<LogReader> a = open_memory(original), b = open_memory(image);
  return compare_twins(*a, *b);
}

TEST(TwinLogs, CarryTheTransformThatMadeThem) {
  const sim::SceneDef scene = falling_heap(sim::Method::kThesis);
  RecordOptions sparse;
  sparse.states.every = 7;
  const Bytes original = record_to_memory(scene, sparse);
  for (const sim::Transform& transform : all_transforms()) {
    RecordOptions options;
    options.transform = transform;
    const Bytes image = record_to_memory(scene, options);
    EXPECT_EQ(open_memory(image)->header().transform, transform);
    const Result<TwinReport> report = compare(original, image);
    ASSERT_TRUE(report.ok()) << report.error().message;
    EXPECT_EQ(report->differing, 0U) << to_string(transform);
    EXPECT_EQ(report->steps, 60U);
  }
}

TEST(TwinLogs, OfOtherScenesOrLengthsAreRefused) {
  const sim::SceneDef scene = falling_heap(sim::Method::kThesis);
  sim::SceneDef other = scene, shorter = scene;
  other.boxes[3].mass *= 2;
  shorter.steps = 59;
  RecordOptions mirrored;
  mirrored.transform.mirror_y = true;
  const Bytes original = record_to_memory(scene), image = record_to_memory(scene, mirrored);
  EXPECT_NE(compare(record_to_memory(other), image).error().message.find("another box"), std::string::npos);
  EXPECT_NE(compare(original, record_to_memory(shorter, mirrored)).error().message.find("found 59 steps"),
            std::string::npos);
  EXPECT_NE(compare(image, image).error().message.find("wanted the original"), std::string::npos);
}

TEST(Twin, ErrorsGoToTheMetricOfTheirKind) {
  TwinReport report;
  report.error = 0.5;
  SymmetryMetrics mirror, order, shift;
  set_twin_error({.swap_xy = true}, report, mirror);
  set_twin_error({.permute = 3}, report, order);
  set_twin_error({.shift = {1, 0, 0}}, report, shift);
  EXPECT_EQ(mirror.mirror_error, 0.5);
  EXPECT_FALSE(mirror.order_error || mirror.shift_error);
  EXPECT_EQ(order.order_error, 0.5);
  EXPECT_FALSE(order.mirror_error || order.shift_error);
  EXPECT_EQ(shift.shift_error, 0.5);
}

}  // namespace
}  // namespace tumble::replay
