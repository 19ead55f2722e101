// "Same" is said of what was read: damage where chains agree, worlds that the scene does not make, parts not compared.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "replay/diff/difference_report.h"
#include "tests/replay/lying_log.h"
#include "tests/support/log_memory.h"
#include "tumble/replay/compare.h"
#include "tumble/replay/continuation.h"
#include "tumble/replay/replayer.h"

namespace tumble::replay {
namespace {

bool has(const std::vector<std::string>& lines, const std::string& words) {
  return std::ranges::any_of(lines, [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

/// The log with one bit of byte `at` flipped.
Bytes flipped(Bytes bytes, std::uint64_t at) {
  bytes[at] ^= std::byte{4};
  return bytes;
}

TEST(Same, DamageIsSeenWhereChainsAgree) {
  const Bytes bytes = record_to_memory(scene_with_inputs(), {}, 8);
  const Result<LogReader> whole = open_memory(bytes);
  Tolerances loose;
  loose.position = 1;
  for (const ChunkPlace& place : whole->chunks()) {
    for (const std::uint64_t at : {place.offset + kPreludeBytes, place.offset + place.length - 1}) {
      for (const Tolerances& tolerances : {Tolerances(), loose}) {
        Result<LogReader> a = open_memory(bytes), b = open_memory(flipped(bytes, at));
        ASSERT_TRUE(b.ok());
        const Result<DiffReport> report = diff_logs(*a, *b, tolerances);
        ASSERT_FALSE(report.ok()) << "byte " << at;
        EXPECT_EQ(report.error().kind, ErrorKind::kDamaged);
        EXPECT_NE(report.error().message.find("chunk at byte"), std::string::npos) << report.error().message;
      }
      Result<LogReader> a = open_memory(bytes), b = open_memory(flipped(bytes, at));
      const Result<DiffReport> brief = diff_logs(*a, *b, {}, {}, Reading::kHashes);
      if (place.first_step == 1 && !brief.ok()) continue;  // its keyframe is read for state 0
      ASSERT_TRUE(brief.ok()) << brief.error().message;
      EXPECT_TRUE(has(brief->scope.not_compared, "not read"));
    }
  }
}

TEST(Same, DamageGoesBeforeADifference) {
  sim::SceneDef other = scene_with_inputs();
  other.boxes[2].velocity.x() = 1;
  const Bytes bytes = record_to_memory(scene_with_inputs(), {}, 8), differs = record_to_memory(other, {}, 8);
  const std::uint64_t last = open_memory(differs)->chunks().back().offset;
  Result<LogReader> a = open_memory(bytes), b = open_memory(flipped(differs, last + kPreludeBytes + 3));
  const Result<DiffReport> report = diff_logs(*a, *b);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().kind, ErrorKind::kDamaged);
}

using Change = std::function<void(sim::WorldState&)>;

/// A session as a build would record it that makes another world of the scene.
Bytes record_of_another_world(const sim::SceneDef& scene, const Change& change) {
  const auto disk = std::make_shared<Disk>();
  sim::WorldState state = sim::create_world(scene)->state();
  change(state);
  auto writer = LogWriter::create(std::make_unique<MemorySink>(disk), header_for(scene), state);
  Result<Session> session = Session::resume(state, scene);
  EXPECT_TRUE(session.ok()) << session.error().message;
  sim::PhaseHashes hashes;
  for (std::uint64_t k = 1; k <= scene.steps; ++k) {
    hashes.clear();
    const Result<TakenStep> taken = session->step({}, &hashes);
    EXPECT_TRUE(taken.ok());
    const sim::WorldState& now = session->world().state();
    EXPECT_TRUE((*writer)->append({now.def.dt, taken->inputs, hashes.words(), taken->counters}, now).ok());
  }
  EXPECT_TRUE((*writer)->finish().ok());
  return disk->bytes;
}

struct Property {
  const char* field;
  bool of_body;
  Change change;
};

std::vector<Property> properties() {
  return {{"world.gravity.z", false, [](sim::WorldState& s) { s.def.gravity.z() *= 1.0009765625; }},
          {"world.dt", false, [](sim::WorldState& s) { s.def.dt *= 1.5; }},
          {"world.slip_speed", false, [](sim::WorldState& s) { s.def.slip_speed *= 2; }},
          {"material.friction", false, [](sim::WorldState& s) { s.def.ground_material.friction *= 2; }},
          {"half_extent.y", true, [](sim::WorldState& s) { s.bodies.half_extent.y[1] += 0.0009765625; }},
          {"mass", true, [](sim::WorldState& s) { s.bodies.mass[1] *= 1.0009765625; }},
          {"inverse_mass", true, [](sim::WorldState& s) { s.bodies.inverse_mass[1] *= 1.0009765625; }},
          {"inertia.z", true, [](sim::WorldState& s) { s.bodies.inertia.z[1] *= 1.0009765625; }},
          {"inverse_inertia.x", true, [](sim::WorldState& s) { s.bodies.inverse_inertia.x[1] *= 1.0009765625; }},
          {"friction", true, [](sim::WorldState& s) { s.bodies.friction[1] *= 2; }},
          {"friction_dynamic", true, [](sim::WorldState& s) { s.bodies.friction_dynamic[1] *= 2; }},
          {"restitution", true, [](sim::WorldState& s) { s.bodies.restitution[1] *= 2; }},
          {"low_energy_time", true, [](sim::WorldState& s) { s.bodies.low_energy_time[1] = 0.125; }}};
}

TEST(Same, AWorldThatThisBuildDoesNotMakeOfTheSceneIsNamed) {
  for (const sim::Method method : kMethods) {
    const sim::SceneDef scene = small_scene(10, method);
    const Bytes truth = record_to_memory(scene);
    for (const Property& property : properties()) {
      SCOPED_TRACE(property.field);
      const Bytes bytes = record_of_another_world(scene, property.change);
      Result<LogReader> log = open_memory(bytes), ours = open_memory(truth);
      const Result<ReplayReport> replayed = replay_log(*log);
      ASSERT_TRUE(replayed.ok()) << replayed.error().message;
      ASSERT_TRUE(replayed->first);
      EXPECT_EQ(replayed->first->step, 0U);
      EXPECT_EQ(replayed->first->phase, "start");
      EXPECT_EQ(replayed->first->field, property.field);
      EXPECT_EQ(replayed->first->body, property.of_body ? std::optional<sim::BodyId>(11) : std::nullopt);
      const Result<DiffReport> diff = diff_logs(*log, *ours);
      ASSERT_TRUE(diff.ok()) << diff.error().message;
      ASSERT_TRUE(diff->first) << "the logs differ in this property at least";
      EXPECT_EQ(diff->first->step, 0U) << "a difference that shows later is its consequence";
      EXPECT_EQ(diff->first->field, property.field);
      const bool is_built = std::string(property.field) != "low_energy_time";
      EXPECT_EQ(diff->built.has_value(), is_built);
      if (!diff->built) continue;
      EXPECT_EQ(diff->built->field, property.field);
      EXPECT_NE(cause_of(*diff, *diff->first).find(property.field), std::string::npos);
    }
  }
}

TEST(Same, AKeyframeAlongTheWayIsComparedWithTheReplayedWorld) {
  const sim::SceneDef scene = small_scene(300);
  const Result<LogReader> truth = open_memory(record_to_memory(scene));
  ASSERT_GE(truth->chunks().size(), 2U);
  const std::uint64_t end = truth->chunks()[1].first_step - 1;
  const Bytes bytes = record_with_lie(
      scene, end, [](sim::WorldState& state, Words&, sim::StepCounters&) { state.bodies.inertia.y[2] *= 2; });
  Result<LogReader> log = open_memory(bytes), ours = open_memory(record_to_memory(scene));
  const Result<ReplayReport> replayed = replay_log(*log);
  ASSERT_TRUE(replayed.ok() && replayed->first);
  EXPECT_EQ(replayed->first->step, end);
  EXPECT_EQ(replayed->first->field, "inertia.y");
  EXPECT_EQ(replayed->first->body, 12U);
  const Result<DiffReport> diff = diff_logs(*ours, *log);
  ASSERT_TRUE(diff.ok() && diff->first) << "all steps are equal, the hidden state is not";
  EXPECT_EQ(diff->first->step, end);
  EXPECT_EQ(diff->first->field, "inertia.y");
}

TEST(Same, AStoppedReplayIsNoAnswer) {
  Result<LogReader> log = open_memory(record_to_memory(small_scene()));
  const Result<ReplayReport> report = replay_log(*log, {}, [](std::uint64_t done, std::uint64_t) { return done < 7; });
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().kind, ErrorKind::kCannotFinish);
  EXPECT_NE(report.error().message.find("identical so far: 7 steps"), std::string::npos) << report.error().message;
}

TEST(Same, AContinuedLogSaysThatItsFirstStateWasNotCompared) {
  for (const sim::Method method : kMethods) {
    Result<LogReader> from = open_memory(record_to_memory(scene_with_inputs(40, method)));
    const auto disk = std::make_shared<Disk>();
    auto recorder = Recorder::go_on(std::make_unique<MemorySink>(disk), *from, 15, {});
    ASSERT_TRUE(recorder.ok() && (*recorder)->run().ok() && (*recorder)->finish().ok());
    Result<LogReader> log = open_memory(disk->bytes);
    const Result<ReplayReport> replayed = replay_log(*log);
    ASSERT_TRUE(replayed.ok()) << replayed.error().message;
    EXPECT_TRUE(replayed->identical()) << describe(*replayed->first);
    EXPECT_TRUE(has(replayed->scope.not_compared, "the first state"));
    EXPECT_TRUE(has(replayed->scope.compared, "masses"));
  }
}

TEST(Same, ListsWhatWasComparedAndWhatWasNot) {
  Result<LogReader> a = open_memory(record_to_memory(scene_with_inputs(), {}, 8));
  RecordOptions sparse;
  sparse.states = {4};
  Result<LogReader> b = open_memory(record_to_memory(scene_with_inputs(), sparse, 8));
  const Result<DiffReport> report = diff_logs(*a, *b);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_TRUE(report->identical());
  for (const char* part : {"step lengths", "inputs", "counters", "phase hashes", "states of 10 steps", "5 keyframes"}) {
    EXPECT_TRUE(has(report->scope.compared, part)) << part;
  }
  EXPECT_TRUE(has(report->scope.not_compared, "states of 30 steps"));
  const Result<ReplayReport> replayed = replay_log(*b);
  ASSERT_TRUE(replayed.ok() && replayed->identical());
  EXPECT_TRUE(has(replayed->scope.compared, "the world made of the scene"));
  EXPECT_TRUE(has(replayed->scope.compared, "4 later keyframes"));
  EXPECT_TRUE(has(replayed->scope.not_compared, "stored states"));
}

}  // namespace
}  // namespace tumble::replay
