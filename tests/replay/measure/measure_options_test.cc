// Measures over some bodies, along one axis, from a step on; and the table of all metrics.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "replay/measure/measure.h"
#include "replay/measure/metric_list.h"
#include "tests/support/hand_states.h"

namespace tumble::replay {
namespace {

using Kind = sim::Origin::Kind;

BoxDef of_table(sim::BodyId id, Kind kind, std::uint32_t table) {
  BoxDef def = box(id, {0, 0, 1});
  def.origin.kind = kind;
  def.origin.table = table;
  return def;
}

TEST(BodyChoice, HoldsWhatItsTextSays) {
  const Result<BodyChoice> choice = parse_bodies("7,10-12,tower:1,pile");
  ASSERT_TRUE(choice.ok());
  EXPECT_EQ(to_string(*choice), "7,10-12,tower:1,pile");
  for (const sim::BodyId id : {7U, 10U, 11U, 12U}) EXPECT_TRUE(choice->holds(box(id, {0, 0, 0}))) << id;
  for (const sim::BodyId id : {1U, 9U, 13U}) EXPECT_FALSE(choice->holds(box(id, {0, 0, 0}))) << id;
  EXPECT_TRUE(choice->holds(of_table(99, Kind::kTower, 1)));
  EXPECT_FALSE(choice->holds(of_table(99, Kind::kTower, 0)));
  EXPECT_TRUE(choice->holds(of_table(99, Kind::kPile, 4)));
  EXPECT_TRUE(parse_bodies("all")->holds(box(1, {0, 0, 0})));
  EXPECT_TRUE(parse_bodies("input")->holds(of_table(3, Kind::kInput, 0)));
}

TEST(BodyChoice, SaysWhatItDoesNotUnderstand) {
  for (const char* text : {"", "7,", "9-7", "towers", "tower:", "tower:x", "-3", "1 2"}) {
    const Result<BodyChoice> choice = parse_bodies(text);
    ASSERT_FALSE(choice.ok()) << text;
    EXPECT_NE(choice.error().message.find("wanted all, or ids"), std::string::npos) << choice.error().message;
  }
}

// Two bodies that move apart: 1 along x, 2 along y.
class MeasureOver : public testing::Test {
 protected:
  MeasureOver() { header_.scene = scene_of({box(1, {0, 0, 5}), box(2, {9, 0, 5})}); }

  Result<Metrics> measure(const MeasureOptions& options) {
    Measurer measurer(header_, options);
    StepRecord record;
    for (std::uint64_t k = 0; k <= 4; ++k) {
      const auto way = static_cast<double>(k);
      BoxDef second = box(2, {9, 10 * way, 5});
      second.velocity = {0, 2, 0};
      record = step_record(k, {box(1, {way, 0, 5 - way}), second}, 10 + way);
      measurer.add(record);
    }
    return measurer.finish(record.states);
  }

  LogHeader header_;
};

TEST_F(MeasureOver, SomeBodiesOnly) {
  EXPECT_EQ(measure({})->symmetry.lateral_max, 4);
  EXPECT_EQ(measure({})->stacking.drift_max, 40);
  EXPECT_EQ(measure({})->stacking.kinetic_end(), 2);
  const Metrics first = *measure({.bodies = *parse_bodies("1")});
  EXPECT_EQ(first.stacking.drift_max, 4);
  EXPECT_EQ(first.stacking.kinetic_end(), 0);
  EXPECT_EQ(first.energy.gain_max, measure({})->energy.gain_max) << "energy is that of all";
  EXPECT_EQ(measure({.bodies = *parse_bodies("2")})->stacking.top_drop_max, 0);
}

TEST_F(MeasureOver, AlongTheOtherAxis) { EXPECT_EQ(measure({.lateral = LateralAxis::kY})->symmetry.lateral_max, 40); }

TEST_F(MeasureOver, FromALaterStepOn) {
  const Metrics later = *measure({.from_step = 3});
  EXPECT_EQ(later.symmetry.lateral_max, 1);
  EXPECT_EQ(later.stacking.drift_max, 10);
  EXPECT_EQ(later.stacking.top_drop_max, 1);
  EXPECT_EQ(later.steps, 4U);
  EXPECT_EQ(later.energy.initial, 2 + 10 * (2 + 5)) << "of the states after step 3";
}

TEST_F(MeasureOver, NothingIsAnError) {
  const Result<Metrics> none = measure({.bodies = *parse_bodies("3-9")});
  ASSERT_FALSE(none.ok());
  EXPECT_NE(none.error().message.find("found none of \"3-9\""), std::string::npos) << none.error().message;
  const Result<Metrics> late = measure({.from_step = 5});
  ASSERT_FALSE(late.ok());
  EXPECT_NE(late.error().message.find("found no step 5"), std::string::npos) << late.error().message;
}

TEST(Measurer, ABodyThrownBeforeTheStartBelongsToIt) {
  LogHeader header;
  header.scene = scene_of({box(2, {0, 0, 5})});
  Measurer measurer(header, {.from_step = 1});
  measurer.add(step_record(0, {box(2, {0, 0, 5})}));
  StepRecord record = step_record(1, {box(1, {9, 0, 5}), box(2, {0, 0, 5})});
  record.inputs.emplace_back(sim::Throw{box(1, {9, 0, 6})});
  measurer.add(record);
  record = step_record(2, {box(1, {9, 3, 5}), box(2, {0, 0, 5})});
  measurer.add(record);
  EXPECT_EQ(measurer.finish(record.states)->stacking.drift_max, 3);
}

// As bodies of a table that lacks them for a step.
TEST(Measurer, ABodyThatCameBackBeforeTheStartIsOne) {
  const std::vector<BoxDef> both = {box(1, {9, 0, 5}), box(2, {0, 0, 5})};
  LogHeader header;
  header.scene = scene_of(both);
  Measurer measurer(header, {.from_step = 2});
  measurer.add(step_record(0, both));
  StepRecord gone = step_record(1, {both[1]}), back = step_record(2, both);
  gone.inputs.emplace_back(sim::Remove{1});
  back.inputs.emplace_back(sim::Throw{both[0]});
  measurer.add(gone);
  measurer.add(back);
  const StepRecord last = step_record(3, both, 0, 100);
  measurer.add(last);
  EXPECT_EQ(measurer.finish(last.states)->energy.initial, 100);
}

TEST(MetricList, NamesAreUniqueAndGroupsStayTogether) {
  std::set<std::string> names, groups;
  std::string group;
  for (const MetricRow& metric : metric_list()) {
    EXPECT_TRUE(names.insert(metric.name).second) << metric.name;
    if (group != metric.group) {
      EXPECT_TRUE(groups.insert(metric.group).second) << metric.group;
    }
    group = metric.group;
    EXPECT_EQ(find_metric(metric.name), &metric);
  }
  EXPECT_EQ(find_metric("lateral"), nullptr);
}

// Two rows that read the same field, or the wrong one, would show here.
TEST(MetricList, EveryRowReadsItsOwnField) {
  Metrics m;
  double next = 1;
  m.symmetry = {.lateral_max = next++,
                .lateral_rms = next++,
                .column_spread = next++,
                .mirror_error = next++,
                .order_error = next++,
                .shift_error = next++};
  m.energy = {.initial = next++,
              .final = next++,
              .gain_max = next++,
              .gain_ratio = next++,
              .removed = next++,
              .inputs = next++,
              .bounce_height_loss = next++,
              .bounces = static_cast<std::uint64_t>(next++),
              .momentum_drift = next++,
              .spin_energy_gain = next++};
  m.stacking = {.drift_max = next++,
                .tilt_max = next++,
                .top_drop_max = next++,
                .lost = static_cast<std::uint64_t>(next++),
                .overlap_max = next++,
                .overlap_peak = next++,
                .ground_penetration_max = next++,
                .ground_penetration_peak = next++};
  const double peak = next;  // kinetic_end is a sum, the row after the last one set
  m.stacking.kinetic_linear_end = peak + 1;
  m.stacking.kinetic_rotational_end = -1;
  m.stacking.frozen_fraction = peak + 3;
  m.stacking.rest_time = peak + 4;
  EXPECT_EQ(find_metric("drift_max")->value(m), std::nullopt) << "over no body";
  m.bodies_at_end = m.of_start_at_end = 1;
  double wanted = 1;
  for (const MetricRow& metric : metric_list()) {
    const std::string name = metric.name;
    if (name == "kinetic_rotational_end") {
      EXPECT_EQ(metric.value(m), -1);
      ++wanted;
      continue;
    }
    EXPECT_EQ(metric.value(m), wanted) << name;
    ++wanted;
  }
}

}  // namespace
}  // namespace tumble::replay
