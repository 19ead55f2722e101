// Nothing is called different that is not: signs of rotations and of zeros, angles, excused inputs. And a body without
// a finite place is infinitely far away.
#include "tumble/replay/tolerance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "replay/diff/difference_report.h"
#include "replay/log/byte_memory.h"
#include "tests/replay/lying_log.h"
#include "tests/support/log_memory.h"
#include "tumble/replay/compare.h"
#include "tumble/replay/engine_log.h"

namespace tumble::replay {
namespace {

bool has(const std::vector<std::string>& lines, const std::string& words) {
  return std::ranges::any_of(lines, [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

Tolerances tolerance(const std::string& field, double value) {
  Tolerances tolerances;
  EXPECT_TRUE(set_tolerance(tolerances, field, value).ok()) << field;
  return tolerances;
}

DiffReport diff_of(const Bytes& bytes_a, const Bytes& bytes_b, const Tolerances& tolerances = {}) {
  Result<LogReader> a = open_memory(bytes_a), b = open_memory(bytes_b);
  Result<DiffReport> report = diff_logs(*a, *b, tolerances);
  EXPECT_TRUE(report.ok()) << report.error().message;
  return *std::move(report);
}

Bytes with_orientation(const sim::SceneDef& scene, const sim::Quat& turn) {
  return record_with_lie(scene, scene.steps, [&](sim::WorldState& state, Words&, sim::StepCounters&) {
    state.bodies.orientation.set(1, turn);
  });
}

sim::Quat negated(const sim::Quat& q) { return {-q.w, -q.x, -q.y, -q.z}; }

/// q turned by `angle` about z.
sim::Quat turned(const sim::Quat& q, double angle) {
  const double c = std::cos(angle / 2), s = std::sin(angle / 2);
  return {c * q.w - s * q.z, c * q.x - s * q.y, c * q.y + s * q.x, c * q.z + s * q.w};
}

TEST(Rotations, OneRotationOfOtherSignIsSaidAndWithTolerancesEqual) {
  const sim::SceneDef scene = small_scene(12);
  const Bytes truth = record_to_memory(scene);
  const sim::Quat q = simulate(scene).back().orientation[1];
  const Bytes other = with_orientation(scene, negated(q));
  const DiffReport exactly = diff_of(truth, other);
  ASSERT_TRUE(exactly.first) << "other bits";
  EXPECT_EQ(exactly.first->field, "orientation.w");
  EXPECT_EQ(exactly.first->note, "same rotation, other sign");
  for (const char* field : {"position", "orientation", "velocity"}) {
    EXPECT_TRUE(diff_of(truth, other, tolerance(field, 1e-9)).identical()) << field;
  }
}

TEST(Rotations, ToleranceIsTheAngle) {
  const sim::SceneDef scene = small_scene(12);
  const Bytes truth = record_to_memory(scene);
  const sim::Quat q = simulate(scene).back().orientation[1];
  for (const double angle : {1e-9, 1e-3, 0.5, 3.0}) {
    for (const sim::Quat& other : {turned(q, angle), negated(turned(q, angle))}) {
      EXPECT_NEAR(angle_between(q, other), angle, 1e-12);
      const Bytes bytes = with_orientation(scene, other);
      EXPECT_TRUE(diff_of(truth, bytes, tolerance("orientation", angle * 1.001)).identical()) << angle;
      const DiffReport beyond = diff_of(truth, bytes, tolerance("orientation", angle * 0.999));
      ASSERT_TRUE(beyond.first) << angle;
      EXPECT_NE(beyond.first->note.find("rad apart"), std::string::npos) << beyond.first->note;
    }
  }
  EXPECT_TRUE(std::isnan(angle_between({0, 0, 0, 0}, q)));
  const sim::Quat doubled = {2 * q.w, 2 * q.x, 2 * q.y, 2 * q.z};
  const DiffReport longer = diff_of(truth, with_orientation(scene, doubled), tolerance("orientation", 0.5));
  ASSERT_TRUE(longer.first) << "one turn, and no rotation";
  EXPECT_EQ(longer.first->note, "same rotation, quaternion of other length");
}

/// A body of another engine with these states after steps 1, 2, …
MemoryFile engine_log(const std::vector<EngineState>& states, const char* version = "1") {
  auto file = std::make_shared<std::vector<std::byte>>();
  sim::SceneDef start;
  start.name = "toy";
  start.boxes.emplace_back().id = 1;
  auto log = EngineLog::create(std::make_unique<MemoryByteSink>(file, "toy.tumble"), {{"toy", version}}, start);
  EXPECT_TRUE(log.ok()) << log.error().message;
  for (const EngineState& state : states) {
    EXPECT_TRUE((*log)->set_state(1, state).ok());
    EXPECT_TRUE((*log)->end_step(0.1).ok());
  }
  EXPECT_TRUE((*log)->finish().ok());
  return file;
}

Result<LogReader> open(const MemoryFile& file) {
  return LogReader::open(std::make_unique<MemoryByteSource>(file, "toy.tumble"));
}

EngineState at(const sim::Vec3& position) {
  EngineState state;
  state.position = position;
  return state;
}

TEST(Zeros, OfAnotherEngineAreOneNumber) {
  Result<LogReader> a = open(engine_log({at({1, 0.0, 2}), at({0.0, 1, 2})}));
  Result<LogReader> b = open(engine_log({at({1, -0.0, 2}), at({-0.0, 1, 2})}));
  const Result<DiffReport> report = diff_logs(*a, *b);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_TRUE(report->identical()) << describe(*report->first);
  EXPECT_TRUE(has(report->scope.not_compared, "the sign of 2 zeros"));
  EXPECT_EQ(report->zeros, 2U);
  Result<LogReader> c = open(engine_log({at({1, -0.0, 2}), at({-0.0, 1, 3})}));
  EXPECT_EQ(diff_logs(*a, *c)->first->field, "position.z");
  const sim::SceneDef scene = small_scene(3);
  const Bytes ours = record_with_lie(
      scene, 3, [](sim::WorldState& state, Words&, sim::StepCounters&) { state.bodies.velocity.y[0] = -0.0; });
  const DiffReport own = diff_of(record_to_memory(scene), ours);
  ASSERT_TRUE(own.first) << "no state of ours holds a negative zero";
  EXPECT_EQ(own.first->note, "zeros of other sign");
}

TEST(Zeros, OfAChangeOfAxesAreNoCause) {
  LogHeader ours = header_for(small_scene(3));
  LogHeader imported = ours;
  imported.scene.world.gravity.y() = -0.0;
  imported.scene.boxes[0].velocity.x() = -0.0;
  imported.scene.boxes[0].mass = 3;
  const std::vector<HeaderDifference> found = header_differences(ours, imported);
  ASSERT_EQ(found.size(), 1U) << describe(found.front());
  EXPECT_EQ(found.front().key, "body 10 mass");
}

TEST(Engines, ThatTellNoPlanHaveNoOther) {
  LogHeader planned = header_for(small_scene(3)), open = planned;
  open.scene.steps = 0;
  EXPECT_TRUE(header_differences(planned, open).empty());
  planned.scene.steps = 1 + (open.scene.steps = 5);
  EXPECT_EQ(header_differences(planned, open).size(), 1U);
}

TEST(Engines, AreComparedByTheirStatesSoNoMethodIsTheCause) {
  const LogHeader ours = header_for(small_scene(3, sim::Method::kLayered));
  LogHeader theirs = header_for(small_scene(3));
  theirs.engine = {"toy", "1", kBinary64Bits};
  theirs.method = "engine";
  theirs.method_version = 0;
  theirs.scene.world.substeps = ours.scene.world.substeps + 1;
  const std::vector<HeaderDifference> found = header_differences(ours, theirs);
  EXPECT_FALSE(found.empty());
  const HeaderDifference* cause = first_cause(found);
  EXPECT_EQ(cause, nullptr) << describe(*cause);
  theirs.scene.world.gravity.z() = -1;
  cause = first_cause(header_differences(ours, theirs));
  ASSERT_NE(cause, nullptr);

  Result<LogReader> a = open(engine_log({at({1, 0, 2}), at({0, 1, 2})}));
  Result<LogReader> b = open(engine_log({at({1, 0, 2}), at({0, 1, 3})}, "2"));
  const Result<DiffReport> report = diff_logs(*a, *b);
  ASSERT_TRUE(report.ok() && report->first);
  EXPECT_EQ(cause_of(*report, *report->first), "step 2 came out otherwise: body 1 position.z: 2 → 3");
}

TEST(Headers, ManyBodiesThatDifferAreSaidAndCountedOnce) {
  sim::SceneDef a, b;
  for (sim::BodyId id = 1; id <= 250; ++id) {
    a.boxes.emplace_back().id = id;
    b.boxes.emplace_back().id = id;
    b.boxes.back().mass += static_cast<double>(id);
    b.boxes.back().position.x() += static_cast<double>(id);
  }
  const std::string last = scene_differences(a, b).back().key;
  EXPECT_EQ(last, "further values of bodies 101, 102, 103, 104 and 146 more");
}

TEST(LostBodies, HaveOneFieldInEveryReport) {
  const double nan = std::nan("");
  EngineState lost = at({0, 0, nan});
  lost.velocity.x() = nan;
  Result<LogReader> a = open(engine_log({at({0, 0, 1})})), b = open(engine_log({lost}));
  const Result<DiffReport> found = diff_logs(*a, *b);
  ASSERT_TRUE(found.ok() && found->first);
  EXPECT_TRUE(has(found->notes, "position.z is nan"));
  const Result<DifferenceReport> report = report_difference(*a, *b, *found);
  ASSERT_TRUE(report.ok() && report->growth && report->growth->separation.lost);
  EXPECT_EQ(report->growth->separation.lost->field, "position.z");
}

TEST(LostBodies, AreInfinitelyFarAwayAndNamed) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  EngineState odd = at({0, 0, 0});
  odd.spin.y() = inf;
  for (const EngineState& lost : {at({nan, 0, 0}), at({0, 0, -inf}), odd}) {
    Result<LogReader> a = open(engine_log({at({0, 0, 0}), at({0, 0, 0}), at({0, 0, 0})}));
    Result<LogReader> b = open(engine_log({at({0, 0, 0}), lost, lost}));
    const Result<DiffReport> found = diff_logs(*a, *b);
    ASSERT_TRUE(found.ok() && found->first);
    ASSERT_EQ(found->notes.size(), 1U);
    EXPECT_NE(found->notes[0].find("body 1 is lost from step 2 on"), std::string::npos) << found->notes[0];
    const Result<DifferenceReport> report = report_difference(*a, *b, *found);
    ASSERT_TRUE(report.ok() && report->growth) << report.error().message;
    const Separation& separation = report->growth->separation;
    EXPECT_TRUE(std::isinf(separation.largest.separation));
    EXPECT_EQ(separation.largest.body, 1U);
    ASSERT_TRUE(separation.lost);
    EXPECT_EQ(separation.lost->step, 2U);
    EXPECT_FALSE(separation.lost->in_a);
    EXPECT_EQ(separation.marks.size(), kSeparationMarks.size());
    EXPECT_FALSE(separation.had_contacts) << "another engine's log has none to compare";
    EXPECT_FALSE(report->location.taken) << "no build of ours takes that step";
    EXPECT_TRUE(report->location.not_taken.empty());
    for (const char* field : {"position", "orientation", "velocity", "spin"}) {
      EXPECT_FALSE(diff_logs(*a, *b, tolerance(field, 1e300))->identical()) << field;
    }
  }
}

TEST(LostBodies, WithEqualBitsAreEqualAndNamed) {
  const std::vector<EngineState> states = {at({0, 0, 0}), at({std::nan(""), 0, 0})};
  Result<LogReader> a = open(engine_log(states)), b = open(engine_log(states));
  const Result<DiffReport> report = diff_logs(*a, *b);
  ASSERT_TRUE(report.ok());
  EXPECT_TRUE(report->identical());
  EXPECT_EQ(report->notes.size(), 2U);
}

TEST(Excuses, AnInputsFieldSoThatItsConsequenceShows) {
  sim::SceneDef other = scene_with_inputs();
  std::get<sim::Throw>(other.inputs[0].command).box.velocity.x() += 0.001953125;
  const Bytes a = record_to_memory(scene_with_inputs()), b = record_to_memory(other);
  const DiffReport plain = diff_of(a, b);
  EXPECT_EQ(plain.first->phase, "inputs");
  EXPECT_EQ(plain.first->field, "throw.velocity.x");
  EXPECT_EQ(cause_of(plain, *plain.first).find("before step 3, body 5 throw.velocity.x: 12 → 12.001953125"), 0U);
  for (const char* field : {"throw.velocity", "throw.velocity.x"}) {
    const DiffReport excused = diff_of(a, b, tolerance(field, 0.01));
    ASSERT_TRUE(excused.first) << field;
    EXPECT_EQ(excused.first->step, 3U);
    EXPECT_EQ(excused.first->body, 5U);
    EXPECT_TRUE(is_in_state(*excused.first)) << describe(*excused.first);
    EXPECT_TRUE(has(excused.scope.not_compared, "differences of throw.velocity"));
    EXPECT_TRUE(excused.headers.back().excused);
    EXPECT_EQ(diff_of(a, b, tolerance(field, 0.0001)).first->phase, "inputs");
  }
  Tolerances unknown;
  const Status status = set_tolerance(unknown, "throw.velocty", 1);
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.error().message.find("is throw.velocity meant?"), std::string::npos) << status.error().message;
  EXPECT_TRUE(set_tolerance(unknown, "world.gravity", 1).ok());
  EXPECT_TRUE(set_tolerance(unknown, "material.friction", 1).ok());
}

TEST(HeaderDifferences, NameEachKeyWithBothValues) {
  sim::SceneDef other = scene_with_inputs();
  other.title = "another";
  other.world.dt = 0.01;
  other.world.ground_material.friction = 0.400001;
  for (sim::BoxDef& box : other.boxes) box.material.friction = 0.400001;
  other.boxes[1].mass = 3;
  other.inputs[1].command = sim::Push{11, {1, 0, 3}, true, {0, 0, 0}};
  std::vector<std::string> lines;
  const auto found = scene_differences(scene_with_inputs(), other);
  lines.reserve(found.size());
  for (const HeaderDifference& difference : found) lines.push_back(describe(difference));
  for (const char* line :
       {"title:  → another", "world.dt: 0.016666666666666666 → 0.01", "material.friction: 0.4 → 0.400001",
        "body 11 mass: 1 → 3", "friction of bodies 10, 11, 12: 0.4 → 0.400001", "input 2 push.impulse.z: 2 → 3"}) {
    EXPECT_TRUE(std::ranges::find(lines, line) != lines.end()) << line << "\n" << testing::PrintToString(lines);
  }
  EXPECT_EQ(lines.size(), 6U) << testing::PrintToString(lines);
  ASSERT_NE(first_cause(found), nullptr);
  EXPECT_EQ(first_cause(found)->key, "world.dt") << "looks cause nothing";
}

TEST(Headlines, CauseAndFirstEffectInAState) {
  sim::SceneDef other = scene_with_inputs(40);
  other.world.gravity.z() = -9.8;
  Result<LogReader> a = open_memory(record_to_memory(scene_with_inputs(40))), b = open_memory(record_to_memory(other));
  const Result<DiffReport> found = diff_logs(*a, *b);
  ASSERT_TRUE(found.ok()) << found.error().message;
  ASSERT_TRUE(found->first);
  const Result<DifferenceReport> report = report_difference(*a, *b, *found);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(report->cause, "world.gravity.z: -9.81 → -9.8");
  ASSERT_TRUE(report->effect);
  EXPECT_TRUE(is_in_state(*report->effect));
  EXPECT_FALSE(magnitude(*report->effect).empty());
}

}  // namespace
}  // namespace tumble::replay
