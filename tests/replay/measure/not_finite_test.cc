// Numbers that are none: a body with one is lost, and no metric over the body holds for any bound, whichever field it
// is and however the metric adds up.
#include "replay/format/not_finite.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "replay/diff/divergence_growth.h"
#include "replay/measure/measure.h"
#include "replay/measure/measure_overlap.h"
#include "replay/measure/metric_bound.h"
#include "replay/measure/metric_list.h"
#include "replay/measure/mirrored_pair.h"
#include "tests/support/hand_states.h"

namespace tumble::replay {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// Three bodies that move a little in four steps. In step 2 the field `column` of the second body is `value`.
std::vector<StepRecord> session(std::size_t column, double value) {
  std::vector<BoxDef> boxes = {box(3, {0, 0, 1}), box(7, {5, 0, 1}), box(9, {9, 0, 1})};
  for (BoxDef& def : boxes) def.spin = {1, 2, 3};
  std::vector<StepRecord> records;
  for (std::uint64_t k = 0; k <= 4; ++k) {
    records.push_back(step_record(k, boxes, 1, 2, 0, 0));
    if (k == 2) (*columns_of(records.back().states)[column])[1] = value;
  }
  return records;
}

sim::SceneDef scene() {
  std::vector<BoxDef> boxes = {box(3, {0, 0, 1}), box(7, {5, 0, 1}), box(9, {9, 0, 1})};
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    boxes[i].spin = {1, 2, 3};
    boxes[i].origin = {sim::Origin::Kind::kGrid, 0, 0, static_cast<std::uint32_t>(i)};
  }
  return scene_of(boxes);
}

Metrics measured(const std::vector<StepRecord>& records, const MeasureOptions& options = {}) {
  LogHeader header;
  header.scene = scene();
  Measurer measurer(header, options);
  for (const StepRecord& record : records) measurer.add(record);
  Result<Metrics> metrics = measurer.finish(records.back().states);
  EXPECT_TRUE(metrics.ok()) << metrics.error().message;
  metrics->symmetry.mirror_error = metrics->symmetry.order_error = metrics->symmetry.shift_error = 0;
  return *metrics;
}

/// Every bound there is on a metric: no value lies outside of all of them.
bool any_bound_holds(const MetricRow& metric, const Metrics& metrics) {
  for (const char* bound : {"<=1e300", ">=-1e300", "<1e300", ">-1e300", "<=0", ">=0"}) {
    const Result<MetricBound> asked = parse_metric_bound(std::string(metric.name) + bound);
    if (asked.ok() && asked->holds(metric.value(metrics))) return true;  // one that judges nothing is refused
  }
  return false;
}

TEST(NotFinite, InAnyFieldFailsEveryBoundOnEveryMetric) {
  for (std::size_t column = 0; column < kColumnCount; ++column) {
    for (const double value : {kNotANumber, -kNotANumber, kInf, -kInf}) {
      const Metrics metrics = measured(session(column, value));
      for (const MetricRow& metric : metric_list()) {
        EXPECT_FALSE(any_bound_holds(metric, metrics)) << metric.name << ", " << kColumnNames[column];
      }
      EXPECT_EQ(metrics.stacking.lost, 1U) << kColumnNames[column];
      ASSERT_TRUE(metrics.not_finite.any) << kColumnNames[column];
      EXPECT_EQ(metrics.not_finite.any->body, 7U);
      EXPECT_EQ(metrics.not_finite.any->step, 2U) << "later states are finite again; the body stays lost";
      EXPECT_EQ(metrics.not_finite.any->field, std::string(kColumnNames[column]));
      EXPECT_EQ(metrics.not_finite.any->bodies, 1U);
    }
  }
}

TEST(NotFinite, WithoutSuchABodyEveryMetricHasItsValue) {
  const Metrics metrics = measured(session(0, 0));
  EXPECT_FALSE(metrics.not_finite.any);
  EXPECT_EQ(metrics.stacking.lost, 0U);
  for (const MetricRow& metric : metric_list()) {
    const std::optional<double> value = metric.value(metrics);
    EXPECT_TRUE(!value || std::isfinite(*value)) << metric.name;
  }
}

TEST(NotFinite, OtherBodiesKeepTheMetricsThatAreTheirs) {
  MeasureOptions options;
  options.bodies = *parse_bodies("3,9");
  const Metrics metrics = measured(session(kSpin, kNotANumber), options);
  EXPECT_FALSE(metrics.not_finite.chosen);
  EXPECT_TRUE(find_metric("drift_max")->value(metrics) == 0.0);
  EXPECT_TRUE(find_metric("lost")->value(metrics) == 0.0);
  for (const char* world : {"initial", "final", "gain_max", "gain_ratio", "removed", "inputs", "overlap_max"}) {
    EXPECT_FALSE(any_bound_holds(*find_metric(world), metrics)) << world << " is over all bodies";
  }
}

TEST(NotFinite, AStaticBodyIsNoMeasureOfOthers) {
  std::vector<BoxDef> boxes = {box(1, {0, 0, 1}), box(2, {4, 0, 1})};
  boxes[1].is_static = true;
  StateMeter meter(scene_of(boxes), states_of(boxes));
  std::vector<BoxDef> now = boxes;
  now[1].position.x() = kNotANumber;
  EXPECT_TRUE(std::isnan(meter.measure(states_of(now), 1).drift_max));
}

// Finite fields may still give sums that are not.
TEST(NotFinite, AnOverflowIsNoValue) {
  std::vector<StepRecord> records = session(0, 0);
  records[2].states.velocity.x[1] = 1e300;
  records[2].counters.kinetic = kInf;
  const Metrics metrics = measured(records);
  EXPECT_FALSE(any_bound_holds(*find_metric("gain_max"), metrics));
  EXPECT_FALSE(any_bound_holds(*find_metric("gain_ratio"), metrics));
  records = session(0, 0);
  records[4].states.velocity.x[1] = 1e300;
  EXPECT_FALSE(any_bound_holds(*find_metric("kinetic_end"), measured(records)));
}

TEST(NotFinite, CountersAreNotDropped) {
  std::vector<StepRecord> records = session(0, 0);
  records[2].counters.kinetic = kNotANumber;
  records[3].counters.removed = kNotANumber;
  const Metrics metrics = measured(records);
  for (const char* name : {"gain_max", "gain_ratio", "removed"}) {
    EXPECT_FALSE(any_bound_holds(*find_metric(name), metrics)) << name;
  }
}

TEST(NotFinite, BoxesWithoutAnExtentAreNotSorted) {
  std::vector<sim::BoxFrame> boxes(100, {{0, 0, 0}, sim::axes_of({}), {0.5, 0.5, 0.5}});
  for (std::size_t i = 0; i < boxes.size(); ++i)
    boxes[i].position.x() = i % 3 == 0 ? kNotANumber : 2.0 * static_cast<double>(i);
  EXPECT_TRUE(std::isnan(deepest_overlap(boxes, std::vector<std::uint8_t>(boxes.size(), 0))));
}

TEST(NotFinite, AMirroredPairHasNoError) {
  for (const bool in_both : {false, true}) {
    std::vector<BoxDef> boxes = {box(1, {0, 0, 1})};
    BodyStates original = states_of(boxes), transformed = original;
    transformed.spin.z[0] = kNotANumber;
    if (in_both) original.spin.z[0] = kNotANumber;
    PairMeter meter({}, {});
    meter.add(0, original, transformed);
    EXPECT_TRUE(std::isnan(meter.report().error));
    EXPECT_EQ(meter.report().differing, 1U);
  }
}

TEST(NotFinite, LargestAndLeastKeepWhatIsNoNumber) {
  EXPECT_EQ(largest(1, 2), 2);
  EXPECT_EQ(least(1, 2), 1);
  EXPECT_TRUE(std::isnan(largest(0, kNotANumber)));
  EXPECT_TRUE(std::isnan(largest(kNotANumber, 0)));
  EXPECT_TRUE(std::isnan(least(0, kNotANumber)));
  EXPECT_TRUE(std::isnan(least(kNotANumber, 0)));
}

// Two sessions that lost the same body have not moved from one another.
TEST(SameValue, IsOneForNaNAndNaNAndForNothingElseThatIsNoNumber) {
  const double nan = std::nan("");
  EXPECT_TRUE(same_value(nan, nan));
  EXPECT_TRUE(same_value(kInf, kInf));
  EXPECT_TRUE(same_value({}, {}));
  EXPECT_TRUE(same_value(1.0, 1.0 + 1e-12));
  for (const auto& [a, b] : {std::pair(nan, 1.0), {kInf, 1.0}, {kInf, -kInf}, {kInf, nan}, {1.0, 1.0 + 1e-6}}) {
    EXPECT_FALSE(same_value(a, b)) << a << ' ' << b;
    EXPECT_FALSE(same_value(b, a)) << b << ' ' << a;
  }
  EXPECT_FALSE(same_value(nan, {}));
  Metrics lost;
  lost.not_finite.any = lost.not_finite.chosen = NotFinite{};
  EXPECT_TRUE(moved_metrics(lost, lost).empty());
}

}  // namespace
}  // namespace tumble::replay
