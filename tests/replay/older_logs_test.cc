// Logs of older builds.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "replay/log/verify.h"
#include "replay/measure/measure_log.h"
#include "tests/fuzz/mend.h"
#include "tests/support/log_memory.h"
#include "tumble/replay/compare.h"
#include "tumble/replay/log_writer.h"
#include "tumble/replay/replayer.h"
#include "tumble/replay/session.h"

namespace tumble::replay {
namespace {

std::string frozen(const std::string& name) { return std::string(TUMBLE_SOURCE_DIR "/tests/data/") + name + ".tumble"; }

/// What a log of tests/data/frozen.toml tells whoever opens it, whatever build wrote it.
void expect_frozen_session(const std::string& name) {
  SCOPED_TRACE(name);
  Result<LogReader> log = LogReader::open(frozen(name));
  ASSERT_TRUE(log.ok()) << log.error().message;
  EXPECT_EQ(log->step_count(), 40U);
  EXPECT_EQ(log->header().scene.name, "frozen");
  EXPECT_EQ(log->header().scene.boxes.size(), 2U);
  EXPECT_EQ(log->header().scene.inputs.size(), 3U);
  EXPECT_FALSE(log->header().goes_on);
  EXPECT_FALSE(log->header().recovered);
  const VerifyReport report = verify(*log);
  EXPECT_TRUE(report.condition.whole()) << report.condition.summary(40);
  EXPECT_EQ(report.states_checked, 40U);
  const Result<const StepRecord*> thrown = log->read_step(5);
  ASSERT_TRUE(thrown.ok());
  EXPECT_EQ((*thrown)->inputs.size(), 1U);
  EXPECT_EQ((*thrown)->states.size(), 3U);
  const Result<Metrics> metrics = measure_log(*log);
  EXPECT_TRUE(metrics.ok()) << metrics.error().message;
}

TEST(OlderLogs, OpenVerifyAndMeasure) {
  for (const char* name : {"format_1.0_thesis",
                           "format_1.0_layered",
                           "format_1.1_thesis",
                           "format_1.1_layered",
                           "format_1.2_thesis",
                           "format_1.2_layered",
                           "format_1.3_thesis",
                           "format_1.3_layered",
                           "format_1.3_hashes_3_thesis",
                           "format_1.3_hashes_3_layered",
                           "format_1.3_methods_3_thesis",
                           "format_1.3_methods_3_layered",
                           "format_1.3_methods_4_thesis",
                           "format_1.3_methods_4_layered",
                           "format_1.3_methods_5_thesis",
                           "format_1.3_methods_5_layered",
                           "format_1.3_hashes_6_thesis",
                           "format_1.3_methods_6_thesis",
                           "format_1.3_methods_6_layered",
                           "format_1.3_methods_7_layered",
                           "format_1.3_methods_8_layered",
                           "format_1.3_methods_9_layered",
                           "format_1.3_methods_7_thesis",
                           "format_1.3_methods_10_layered",
                           "format_1.3_methods_11_layered",
                           "format_1.3_methods_12_layered",
                           "format_1.3_methods_13_layered",
                           "format_1.3_methods_14_layered",
                           "format_1.3_methods_15_layered",
                           "format_1.3_methods_16_layered",
                           "format_1.3_methods_17_layered",
                           "format_1.3_methods_18_layered",
                           "format_1.3_methods_19_layered",
                           "format_1.3_methods_20_layered",
                           "format_1.3_methods_21_layered",
                           "format_1.3_hashes_7_thesis",
                           "format_1.3_hashes_7_layered",
                           "format_1.3_hashes_8_thesis",
                           "format_1.3_hashes_8_layered",
                           "format_1.3_hashes_every_4_layered"}) {
    expect_frozen_session(name);
  }
}

std::string method_version_note(int version) {
  return "the log was recorded with version " + std::to_string(version) + " of method";
}

// The bodies of the frozen session turn and slide: later versions of the methods move them otherwise.
TEST(OlderLogs, OfOtherVersionsOfTheMethodsAreReplayedWithANote) {
  const auto expect_note = [](const std::string& name, int version) {
    Result<LogReader> log = LogReader::open(frozen(name));
    const Result<ReplayReport> report = replay_log(*log);
    ASSERT_TRUE(report.ok()) << report.error().message;
    EXPECT_FALSE(report->identical()) << name;
    ASSERT_FALSE(report->notes.empty()) << name;
    EXPECT_TRUE(report->notes.front().starts_with(method_version_note(version))) << report->notes.front();
  };
  for (const std::string method : {"_thesis", "_layered"}) {
    for (const char* format : {"format_1.0", "format_1.1", "format_1.2"}) expect_note(format + method, 1);
    for (const char* format : {"format_1.3", "format_1.3_hashes_3"}) expect_note(format + method, 2);
    expect_note("format_1.3_methods_3" + method, 3);
  }
  for (const char* name :
       {"format_1.3_methods_7_layered", "format_1.3_hashes_7_layered", "format_1.3_hashes_8_layered"})
    expect_note(name, 7);
  for (const int version : {8, 9, 10, 11, 12, 14}) {
    expect_note("format_1.3_methods_" + std::to_string(version) + "_layered", version);
  }
}

/// Replays a frozen log, which must be the same in every bit, and returns what was noted.
std::vector<std::string> notes_of_same_replay(const std::string& name) {
  Result<LogReader> log = LogReader::open(frozen(name));
  const Result<ReplayReport> report = replay_log(*log);
  EXPECT_TRUE(report.ok() && report->identical()) << name;
  return report.ok() ? report->notes : std::vector<std::string>();
}

TEST(OlderLogs, OfTodayReplayWithNothingToSay) {
  for (const char* name : {"format_1.3_hashes_9_thesis", "format_1.3_methods_21_layered"}) {
    EXPECT_EQ(notes_of_same_replay(name), std::vector<std::string>()) << name;
  }
}

// Version 6 of method thesis moves what meets the edge of a static box, and nothing else.
TEST(OlderLogs, OfAVersionWhoseStatesAreTheSameReplayAlikeWithANote) {
  for (const char* name : {"format_1.3_hashes_6_thesis", "format_1.3_hashes_7_thesis", "format_1.3_hashes_8_thesis"}) {
    const std::vector<std::string> notes = notes_of_same_replay(name);
    ASSERT_FALSE(notes.empty()) << name;
    EXPECT_TRUE(notes.front().starts_with(method_version_note(5))) << notes.front();
  }
}

// Up to format 1.2 phase hashes left out some of what a phase wrote.
TEST(OlderLogs, AreTheSameAsLaterOnesButForPhaseHashes) {
  for (const std::string method : {"_thesis", "_layered"}) {
    SCOPED_TRACE(method);
    Result<LogReader> old = LogReader::open(frozen("format_1.2" + method));
    EXPECT_EQ(old->header().phase_hash_version, 1U);
    Result<LogReader> later = LogReader::open(frozen("format_1.3_hashes_3" + method));
    EXPECT_EQ(later->header().phase_hash_version, 3U);
    const Result<DiffReport> same = diff_logs(*old, *later);
    ASSERT_TRUE(same.ok()) << same.error().message;
    EXPECT_TRUE(same->identical()) << describe(*same->first);
    EXPECT_EQ(same->steps, 40U);
    EXPECT_TRUE(std::ranges::any_of(same->scope.not_compared, [](const std::string& line) {
      return line.starts_with("phase hashes: version 1 and 3");
    }));

    sim::SceneDef other = old->header().scene;
    other.boxes[1].position.x() += 0x1p-20;
    Result<LogReader> moved = open_memory(record_to_memory(other));
    const Result<DiffReport> differs = diff_logs(*old, *moved);
    ASSERT_TRUE(differs.ok() && differs->first);
    EXPECT_EQ(differs->first->field, "position.x");
  }
}

// tests/data/robot.npz, imported by the build that added channels.
TEST(OlderLogs, ChannelsOfAnotherEngineComeBack) {
  Result<LogReader> log = LogReader::open(frozen("format_2.0_engine"));
  ASSERT_TRUE(log.ok()) << log.error().message;
  EXPECT_EQ(log->header().format_major, 2U);
  EXPECT_TRUE(verify(*log).condition.whole());
  const Declared& declared = log->header().declared;
  ASSERT_EQ(declared.channels.size(), 5U);
  const StepRecord& step = **log->read_step(12);
  EXPECT_EQ(step.extras.values(declared.find("seed")).bits.at(0), (1ULL << 63U) + 7);
  EXPECT_EQ(step.extras.values(declared.find("angle")).size(), 2U);
  EXPECT_EQ(log->bodies().name(step.states.id[0]).size() + log->bodies().name(step.states.id[1]).size(), 7U);
}

TEST(OlderLogs, AStateThatDiffersIsFoundWithoutPhaseHashes) {
  Result<LogReader> old = LogReader::open(frozen("format_1.2_layered"));
  sim::SceneDef scene = old->header().scene;
  scene.inputs[1].step += 1;
  Result<LogReader> fresh = open_memory(record_to_memory(scene));
  const Result<DiffReport> report = diff_logs(*old, *fresh);
  ASSERT_TRUE(report.ok() && report->first);
  EXPECT_EQ(report->first->step, 9U);
  EXPECT_EQ(report->first->phase, "inputs");
}

/// A log of a method version that this build does not know, so that no keyframe's hash can be computed again.
Bytes of_unknown_version() {
  const sim::SceneDef scene = small_scene(8);
  LogHeader header = header_for(scene);
  header.method_version = 99;
  const auto disk = std::make_shared<Disk>();
  Result<Session> session = Session::start(scene);
  auto writer = LogWriter::create(std::make_unique<MemorySink>(disk), header, session->world().state());
  sim::PhaseHashes hashes;
  for (std::uint64_t k = 1; k <= scene.steps; ++k) {
    hashes.clear();
    const Result<TakenStep> taken = session->step({}, &hashes);
    const sim::WorldState& state = session->world().state();
    EXPECT_TRUE((*writer)->append({state.def.dt, taken->inputs, hashes.words(), taken->counters}, state).ok());
    if (k % 4 == 0) {
      EXPECT_TRUE((*writer)->flush(state).ok());
    }
  }
  return disk->bytes;  // without an index, whose rows would name the hashes of the chunks
}

TEST(OlderLogs, KeyframesWithOtherHashesAreDifferentThoughNoPropertyIs) {
  const Bytes log = of_unknown_version();
  Result<LogReader> a = open_memory(log);
  const Result<const Keyframe*> keyframe = a->keyframe_at_or_before(4);
  ASSERT_TRUE(keyframe.ok() && (*keyframe)->state.step == 4);
  const auto wanted = std::as_bytes(std::span(&(*keyframe)->continuation_hash.low, 1));
  Bytes open = fuzz::laid_open(log);
  const auto found = std::search(open.begin(), open.end(), wanted.begin(), wanted.end());
  ASSERT_NE(found, open.end());
  *found ^= std::byte{1};
  Result<LogReader> b = open_memory(fuzz::mended(open));
  ASSERT_TRUE(b.ok()) << b.error().message;
  const Result<DiffReport> report = diff_logs(*a, *b);
  ASSERT_TRUE(report.ok()) << report.error().message;
  ASSERT_TRUE(report->first) << "called identical, with complete states of 2 keyframes";
  EXPECT_EQ(report->first->step, 4U);
  EXPECT_EQ(report->first->field, "continuation_hash");
  EXPECT_FALSE(same_bits(report->first->expected, report->first->actual));
}

// Written before the phases of the method were what they are now.
TEST(OlderLogs, ReplaySaysFromWhichStepOtherPhysicsDiffers) {
  Result<LogReader> log = LogReader::open(frozen("format_1.0_layered"));
  const Result<ReplayReport> report = replay_log(*log);
  ASSERT_TRUE(report.ok()) << report.error().message;
  ASSERT_TRUE(report->first);
  EXPECT_GT(report->first->step, 1U);
  EXPECT_EQ(report->first->field, "position.z");
  EXPECT_TRUE(std::ranges::any_of(report->notes, [](const std::string& note) {
    return note.find("phases of the method have changed") != std::string::npos;
  }));
}

}  // namespace
}  // namespace tumble::replay
