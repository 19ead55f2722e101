// Diff: logs of one session are identical, and one changed value anywhere is found and named.
#include <gtest/gtest.h>

#include <cmath>
#include <span>

#include "replay/diff/input_difference.h"
#include "tests/replay/lying_log.h"
#include "tests/support/log_memory.h"
#include "tumble/replay/compare.h"

namespace tumble::replay {
namespace {

DiffReport diff_of(const Bytes& bytes_a, const Bytes& bytes_b, const Tolerances& tolerances = {}) {
  Result<LogReader> a = open_memory(bytes_a);
  Result<LogReader> b = open_memory(bytes_b);
  EXPECT_TRUE(a.ok() && b.ok());
  Result<DiffReport> report = diff_logs(*a, *b, tolerances);
  EXPECT_TRUE(report.ok()) << report.error().message;
  return *std::move(report);
}

TEST(Diff, LogsOfOneSessionAreIdenticalWhateverTheirChunks) {
  const DiffReport report =
      diff_of(record_to_memory(scene_with_inputs(), {}, 3), record_to_memory(scene_with_inputs(), {}, 16));
  EXPECT_TRUE(report.identical());
  EXPECT_EQ(report.steps, 40U);
  EXPECT_TRUE(report.headers.empty());
}

TEST(Diff, TheFirstDifferentStepIsFoundInAnyChunk) {
  const sim::SceneDef scene = small_scene(200);
  const Bytes truth = record_to_memory(scene);
  for (const std::uint64_t lie : {1ULL, 63ULL, 64ULL, 65ULL, 130ULL, 200ULL}) {
    const Bytes bytes = record_with_lie(scene, lie, [](sim::WorldState& state, Words&, sim::StepCounters&) {
      state.bodies.position.z[2] += 1.0 / 1024;
    });
    const DiffReport report = diff_of(truth, bytes);
    ASSERT_TRUE(report.first.has_value()) << lie;
    EXPECT_EQ(report.first->step, lie);
    EXPECT_EQ(report.first->body, 12U);
    EXPECT_EQ(report.first->field, "position.z");
    Tolerances tolerances;
    tolerances.position = 1.0 / 512;
    EXPECT_TRUE(diff_of(truth, bytes, tolerances).identical()) << lie;
    tolerances.position = 1.0 / 2048;
    EXPECT_FALSE(diff_of(truth, bytes, tolerances).identical()) << lie;
  }
}

TEST(Diff, ALongerLogIsNotIdentical) {
  const DiffReport report = diff_of(record_to_memory(small_scene(20)), record_to_memory(small_scene(19)));
  EXPECT_FALSE(report.first.has_value());
  EXPECT_FALSE(report.identical());
  EXPECT_EQ(report.steps, 19U);
  EXPECT_EQ(report.headers.size(), 1U);
}

TEST(Diff, AnotherInputIsFoundBeforeItsStep) {
  sim::SceneDef other = scene_with_inputs();
  other.inputs[1].command = sim::Push{11, {1, 0, 3}, true, {0, 0, 0}};
  const DiffReport report = diff_of(record_to_memory(scene_with_inputs()), record_to_memory(other));
  ASSERT_TRUE(report.first.has_value());
  EXPECT_EQ(report.first->step, 3U);
  EXPECT_EQ(report.first->phase, "inputs");
  EXPECT_EQ(report.first->field, "push.impulse.z");
  EXPECT_EQ(report.first->body, 11U);
  EXPECT_EQ(std::get<double>(report.first->expected), 2);
  EXPECT_EQ(std::get<double>(report.first->actual), 3);
}

std::optional<InputDifference> input_difference(const sim::Command& a, const sim::Command& b) {
  return first_difference(std::span(&a, 1), std::span(&b, 1));
}

TEST(InputDifference, NamesTheFieldOfEachKindOfInput) {
  sim::BoxDef box, heavier, other_look;
  box.id = heavier.id = other_look.id = 3;
  heavier.mass = 2;
  other_look.material.texture = sim::Texture::kBrick;
  EXPECT_EQ(input_difference(sim::Throw{box}, sim::Throw{heavier})->field, "throw.mass");
  EXPECT_FALSE(input_difference(sim::Throw{box}, sim::Throw{other_look})) << "look changes nothing";
  EXPECT_EQ(input_difference(sim::Remove{3}, sim::Remove{4})->field, "remove.id");
  EXPECT_FALSE(input_difference(sim::Remove{3}, sim::Remove{4})->body);
  EXPECT_EQ(input_difference(sim::Wake{3}, sim::Wake{5})->field, "wake.id");
  EXPECT_EQ(
      input_difference(sim::SetVelocity{3, {1, 2, 3}, {0, 0, 0}}, sim::SetVelocity{3, {1, 2, 3}, {0, 0.5, 0}})->field,
      "set_velocity.spin.y");
  EXPECT_EQ(input_difference(sim::SetGravity{{0, 0, -9}}, sim::SetGravity{{0, 0, -8}})->field, "set_gravity.gravity.z");
  EXPECT_EQ(input_difference(sim::SetDt{0.1}, sim::SetDt{0.2})->field, "set_dt.dt");
  const sim::Push centre{3, {1, 0, 0}, true, {0, 0, 0}}, point{3, {1, 0, 0}, false, {0, 0, 1}};
  EXPECT_EQ(input_difference(centre, point)->field, "push.at_centre");
  EXPECT_FALSE(input_difference(centre, sim::Push{3, {1, 0, 0}, true, {9, 9, 9}})) << "a point that is not read";
  const auto kinds = input_difference(sim::Wake{3}, sim::Remove{3});
  EXPECT_EQ(kinds->field, "inputs");
  EXPECT_EQ(std::get<std::string>(kinds->expected), "wake body 3");
  EXPECT_EQ(std::get<std::string>(kinds->actual), "remove body 3");
  EXPECT_TRUE(input_difference(sim::SetDt{0.0}, sim::SetDt{-0.0})) << "to the bit";
}

TEST(Diff, BodiesOfOneLogOnlyAreNamed) {
  sim::SceneDef other = small_scene();
  other.boxes.pop_back();
  const DiffReport report = diff_of(record_to_memory(small_scene()), record_to_memory(other));
  ASSERT_TRUE(report.first.has_value());
  EXPECT_EQ(report.first->step, 0U);
  EXPECT_EQ(report.first->field, "body");
  EXPECT_EQ(report.first->body, 12U);
  EXPECT_EQ(report.first->expected, FieldValue(std::uint64_t{12}));
  EXPECT_EQ(report.first->actual, FieldValue(std::monostate()));
  EXPECT_EQ(describe(*report.first), "step 0, phase start, body 12: expected, but not there");
}

// The next row of a table takes the place of a removed body, and is no other value of it.
TEST(Divergence, ABodyThatIsMissingIsNotTheNextOne) {
  const BodyStates all = simulate(small_scene(0))[0];
  ASSERT_EQ(all.id, (std::vector<sim::BodyId>{10, 11, 12}));
  sim::SceneDef without = small_scene(0);
  without.boxes.erase(without.boxes.begin() + 1);
  const BodyStates some = simulate(without)[0];
  const std::optional<Divergence> gone = first_difference(all, some), added = first_difference(some, all);
  ASSERT_TRUE(gone && added);
  EXPECT_TRUE(is_body_missing(*gone));
  EXPECT_EQ(gone->body, 11U);
  EXPECT_EQ(gone->expected, FieldValue(std::uint64_t{11}));
  EXPECT_EQ(only_in(*gone, "a", "b"), "only in a");
  EXPECT_EQ(added->body, 11U);
  EXPECT_EQ(added->expected, FieldValue(std::monostate()));
  EXPECT_EQ(only_in(*added, "a", "b"), "only in b");
}

TEST(Diff, TolerancesNeedStates) {
  sim::SceneDef other = small_scene();
  other.boxes[2].velocity = {0, 0, 1};
  RecordOptions hashes_only;
  hashes_only.states = {0};
  Result<LogReader> a = open_memory(record_to_memory(small_scene(), hashes_only));
  Result<LogReader> b = open_memory(record_to_memory(other, hashes_only));
  Tolerances tolerances;
  tolerances.velocity = 2;
  const Result<DiffReport> report = diff_logs(*a, *b, tolerances);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().kind, ErrorKind::kBadInput);
}

TEST(Divergence, NaNsAreComparedByTheirBits) {
  BodyStates a = simulate(small_scene(0))[0];
  a.spin.x[1] = std::nan("1");
  BodyStates b = a;
  EXPECT_FALSE(first_difference(a, b).has_value());
  b.spin.x[1] = std::nan("2");
  const std::optional<Divergence> found = first_difference(a, b);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->field, "spin.x");
  EXPECT_FALSE(found->ulps.has_value());
}

TEST(Divergence, UlpsCountDoublesBetween) {
  EXPECT_EQ(ulps_between(1.0, 1.0), 0U);
  EXPECT_EQ(ulps_between(1.0, std::nextafter(1.0, 2.0)), 1U);
  EXPECT_EQ(ulps_between(-0.0, 0.0), 1U);
  EXPECT_EQ(ulps_between(5e-324, -5e-324), 3U);
  EXPECT_FALSE(ulps_between(std::nan(""), 1).has_value());
}

}  // namespace
}  // namespace tumble::replay
