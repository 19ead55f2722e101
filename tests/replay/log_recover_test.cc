// What comes out of a damaged log: every chunk that is whole, in a log that is.
#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "replay/log/verify.h"
#include "replay/measure/measure_log.h"
#include "tests/support/sample_log.h"
#include "tumble/replay/compare.h"
#include "tumble/replay/replayer.h"

namespace tumble::replay {
namespace {

using Gaps = std::vector<MissingSteps>;

/// Every step of the log that is not lost must be what was recorded.
void expect_recorded_steps(const Bytes& bytes, const Gaps& lost) {
  Result<LogReader> log = open_memory(bytes);
  ASSERT_TRUE(log.ok()) << log.error().message;
  for (std::uint64_t k = log->first_state() + 1; k <= log->last_step(); ++k) {
    const bool is_lost =
        std::ranges::any_of(lost, [&](const MissingSteps& gap) { return k >= gap.first_step && k < gap.end_step(); });
    const Result<const StepRecord*> step = log->read_step(k);
    ASSERT_EQ(step.ok(), !is_lost) << k;
    ASSERT_TRUE(is_lost || same_bits((*step)->states, sample_log().states[k])) << k;
  }
}

/// The steps of chunk 1 … 4 of the sample.
MissingSteps steps_of(std::size_t chunk) { return {chunk * 6 - 5, 6}; }

TEST(Recover, AWholeLogComesBackByteForByte) {
  for (const sim::Method method : kMethods) {
    for (const std::uint32_t every : {1U, 5U, 0U}) {
      RecordOptions options;
      options.states.every = every;
      const Bytes bytes = record_to_memory(scene_with_inputs(24, method), options, 6);
      const Result<RecoveredLog> recovered = recover_memory(bytes);
      ASSERT_TRUE(recovered.ok()) << recovered.error().message;
      EXPECT_TRUE(recovered->bytes == bytes);
      EXPECT_TRUE(recovered->report.nothing_lost());
      EXPECT_EQ(recovered->report.lost_bytes, 0U);
      EXPECT_TRUE(recovered->report.damages.empty());
    }
  }
}

TEST(Recover, AFlippedBitAnywhereCostsAtMostTheRecordItIsIn) {
  const SampleLog& s = sample_log();
  for (std::uint64_t byte = 0; byte < s.bytes.size(); ++byte) {
    SCOPED_TRACE("byte " + std::to_string(byte));
    Bytes bytes = s.bytes;
    bytes[byte] ^= static_cast<std::byte>(1U << (byte % 8));
    const Result<RecoveredLog> recovered = recover_memory(bytes);
    ASSERT_TRUE(recovered.ok()) << recovered.error().message;
    const RecoverReport& report = recovered->report;
    const std::uint64_t hurt = s.record_of(byte);
    const bool in_chunk = hurt > 0 && hurt < s.records[5];
    ASSERT_LE(report.lost.size(), in_chunk ? 1U : 0U);
    if (!report.nothing_lost()) {
      ASSERT_GE(byte, hurt + kPreludeBytes) << "a prelude can be made anew";
      ASSERT_EQ(report.header_lost, hurt == 0);
    } else {
      // zstd ignores some bits of a frame; a chunk with such a one is kept with it.
      ASSERT_TRUE(recovered->bytes == s.bytes || byte >= hurt + kPreludeBytes);
    }
    ASSERT_EQ(report.steps, report.lost.empty() ? 24U : 18U);
    ASSERT_TRUE(report.end_known);
    ASSERT_FALSE(report.damages.empty());
    expect_recorded_steps(recovered->bytes, report.lost);
  }
}

TEST(Recover, OfATornLogEveryCompleteChunkIsKept) {
  const SampleLog& s = sample_log();
  for (std::uint64_t length = 0; length <= s.bytes.size(); ++length) {
    SCOPED_TRACE("cut to " + std::to_string(length));
    const Bytes bytes(s.bytes.begin(), s.bytes.begin() + static_cast<std::ptrdiff_t>(length));
    const Result<RecoveredLog> recovered = recover_memory(bytes);
    const auto ends =
        static_cast<std::size_t>(std::upper_bound(s.records.begin(), s.records.end(), length) - s.records.begin());
    if (ends < 3) {  // no chunk ends before the cut
      ASSERT_FALSE(recovered.ok());
      EXPECT_EQ(recovered.error().kind, ErrorKind::kDamaged) << recovered.error().message;
      continue;
    }
    ASSERT_TRUE(recovered.ok()) << recovered.error().message;
    EXPECT_EQ(recovered->report.chunks, std::min<std::size_t>(ends - 2, 4));
    EXPECT_EQ(recovered->report.end_known, ends > 6);
    for (std::size_t chunk = 1; chunk <= recovered->report.chunks; ++chunk) {  // the header says that the end was lost
      const auto payload = std::span(s.bytes).subspan(s.records[chunk] + kPreludeBytes);
      const auto kept = payload.first(s.records[chunk + 1] - s.records[chunk] - kPreludeBytes);
      const std::vector<std::byte>& all = recovered->bytes;
      EXPECT_NE(std::search(all.begin(), all.end(), kept.begin(), kept.end()), all.end()) << chunk;
    }
    expect_recorded_steps(recovered->bytes, {});
  }
}

TEST(Recover, ATailOfZerosIsLeftOut) {
  Bytes bytes = sample_log().joined({0, 1, 2});
  bytes.resize(bytes.size() + 10000);
  const Result<RecoveredLog> recovered = recover_memory(bytes);
  ASSERT_TRUE(recovered.ok()) << recovered.error().message;
  EXPECT_EQ(recovered->report.last_step, 12U);
  EXPECT_EQ(recovered->report.lost_bytes, 10000U);
  EXPECT_FALSE(recovered->report.end_known);
}

TEST(Recover, RecordsInAnyOrderAndTwiceGiveTheLogBack) {
  const SampleLog& s = sample_log();
  for (const std::vector<std::size_t>& order : {std::vector<std::size_t>{0, 2, 1, 3, 4, 5, 6},
                                                {4, 3, 2, 1, 0, 5, 6},
                                                {0, 1, 1, 2, 3, 4, 4, 5, 6},
                                                {6, 5, 0, 1, 2, 3, 4},
                                                {0, 1, 2, 3, 4, 0, 1, 2, 3, 4, 5, 6}}) {
    const Result<RecoveredLog> recovered = recover_memory(s.joined(order));
    ASSERT_TRUE(recovered.ok()) << recovered.error().message;
    EXPECT_TRUE(recovered->bytes == s.bytes);
    EXPECT_TRUE(recovered->report.nothing_lost());
  }
}

TEST(Recover, BytesPutInBetweenAreLeftOut) {
  const SampleLog& s = sample_log();
  for (std::size_t record = 0; record < s.records.size(); ++record) {
    Bytes bytes = s.bytes;
    bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(s.records[record]), 777, std::byte{0x28});
    const Result<RecoveredLog> recovered = recover_memory(bytes);
    ASSERT_TRUE(recovered.ok()) << recovered.error().message;
    EXPECT_TRUE(recovered->bytes == s.bytes);
    EXPECT_EQ(recovered->report.lost_bytes, 777U);
  }
}

TEST(Recover, ChunksOfAnotherLogAreLeftOut) {
  const SampleLog& s = sample_log();
  sim::SceneDef other = scene_with_inputs(24);
  other.title = "another header";
  const Bytes foreign = record_to_memory(other, {}, 6);
  const Result<LogReader> source = open_memory(foreign);
  const ChunkPlace& place = source->chunks()[1];
  Bytes bytes = s.joined({0, 1});
  bytes.insert(bytes.end(), foreign.begin() + static_cast<std::ptrdiff_t>(place.offset),
               foreign.begin() + static_cast<std::ptrdiff_t>(place.offset + place.length));
  const Bytes rest = s.joined({3, 4, 5, 6});
  bytes.insert(bytes.end(), rest.begin(), rest.end());
  const Result<RecoveredLog> recovered = recover_memory(bytes);
  ASSERT_TRUE(recovered.ok()) << recovered.error().message;
  EXPECT_EQ(recovered->report.lost, Gaps{steps_of(2)});
  EXPECT_NE(recovered->report.damages.front().message.find("another log"), std::string::npos);
  EXPECT_EQ(recovered->report.others.steps, 6U);
}

TEST(Recover, OfTwoSessionsWithOneHeaderTheLongerIsKept) {
  const SampleLog& s = sample_log();
  // The same scene and so the same header, but steered otherwise while it ran.
  const auto disk = std::make_shared<Disk>();
  auto recorder = Recorder::start(std::make_unique<MemorySink>(disk), scene_with_inputs(24), {});
  ASSERT_TRUE(recorder.ok());
  const std::vector<sim::Command> live = {sim::SetVelocity{11, {0, 3, 0}, {0, 0, 0}}};
  ASSERT_TRUE((*recorder)->step(live).ok());
  for (int k = 2; k <= 6; ++k) ASSERT_TRUE((*recorder)->step().ok());
  ASSERT_TRUE((*recorder)->flush().ok());
  Bytes bytes(disk->bytes);
  const Bytes rest = s.joined({1, 2, 3, 4, 5, 6});
  bytes.insert(bytes.end(), rest.begin(), rest.end());
  const Result<RecoveredLog> recovered = recover_memory(bytes);
  ASSERT_TRUE(recovered.ok()) << recovered.error().message;
  EXPECT_TRUE(recovered->bytes == s.bytes);
  EXPECT_NE(recovered->report.damages.front().message.find("does not fit the others"), std::string::npos);
  EXPECT_EQ(recovered->report.others.unfit_chunks, 1U);
  EXPECT_FALSE(recovered->report.nothing_lost());
}

TEST(Recover, AChunkLostInTheMiddleLeavesAGapThatReadersName) {
  const SampleLog& s = sample_log();
  const Result<RecoveredLog> recovered = recover_memory(s.joined({0, 1, 3, 4, 5, 6}));
  ASSERT_TRUE(recovered.ok()) << recovered.error().message;
  EXPECT_EQ(recovered->report.lost, Gaps{steps_of(2)});
  Result<LogReader> log = open_memory(recovered->bytes);
  EXPECT_FALSE(log->condition().whole());
  EXPECT_NE(log->condition().summary(24).find("steps 7 to 12 were lost"), std::string::npos);
  EXPECT_NE(log->read_step(9).error().message.find("was lost before this log was recovered"), std::string::npos);

  const Result<ReplayReport> replayed = replay_log(*log);
  ASSERT_TRUE(replayed.ok()) << replayed.error().message;
  EXPECT_TRUE(replayed->identical());
  EXPECT_EQ(replayed->steps, 18U);
  EXPECT_NE(replayed->notes.back().find("steps 7 to 12 were lost"), std::string::npos);

  Result<LogReader> original = open_memory(s.bytes);
  const Result<DiffReport> same = diff_logs(*original, *log);
  ASSERT_TRUE(same.ok()) << same.error().message;
  EXPECT_TRUE(same->identical());

  const Result<Metrics> measured = measure_log(*log);
  ASSERT_TRUE(measured.ok()) << measured.error().message;
  MeasureOptions late;
  late.from_step = 12;
  EXPECT_NE(measure_log(*log, late).error().message.find("steps 7 to 12 were lost"), std::string::npos);
}

TEST(Recover, ADifferenceBehindAGapIsFound) {
  const SampleLog& s = sample_log();
  sim::SceneDef other = scene_with_inputs(24);
  other.inputs.back() = {20, sim::SetVelocity{99, {0, 1, 0}, {0, 0, 0}}};
  Result<LogReader> changed = open_memory(record_to_memory(other, {}, 6));
  const Result<RecoveredLog> recovered = recover_memory(s.joined({0, 1, 3, 4, 5, 6}));
  Result<LogReader> log = open_memory(recovered->bytes);
  const Result<DiffReport> report = diff_logs(*log, *changed);
  ASSERT_TRUE(report.ok()) << report.error().message;
  ASSERT_TRUE(report->first);
  EXPECT_EQ(report->first->step, 20U);
}

TEST(Recover, AKeyframeBehindAGapIsNotCalledCompared) {
  const SampleLog& s = sample_log();
  Result<LogReader> log = open_memory(recover_memory(s.joined({0, 1, 3, 4, 5, 6}))->bytes);
  const Result<ReplayReport> replayed = replay_log(*log);
  ASSERT_TRUE(replayed.ok() && replayed->identical());
  const auto says = [&](const char* words) {
    return std::ranges::any_of(replayed->scope.compared,
                               [&](const std::string& line) { return line.find(words) != std::string::npos; });
  };
  EXPECT_TRUE(says("complete states of 1 later keyframe")) << "the replay starts again from the one of step 12";
}

TEST(Recover, WithoutItsFirstChunkALogGoesOnFromAState) {
  const SampleLog& s = sample_log();
  const Result<RecoveredLog> recovered = recover_memory(s.joined({0, 2, 4, 5, 6}));
  ASSERT_TRUE(recovered.ok()) << recovered.error().message;
  EXPECT_EQ(recovered->report.lost, (Gaps{steps_of(1), steps_of(3)}));
  Result<LogReader> log = open_memory(recovered->bytes);
  EXPECT_EQ(log->first_state(), 6U);
  const Result<ReplayReport> replayed = replay_log(*log);
  ASSERT_TRUE(replayed.ok()) << replayed.error().message;
  EXPECT_TRUE(replayed->identical());
  EXPECT_EQ(replayed->steps, 12U);
  Result<LogReader> original = open_memory(s.bytes);
  EXPECT_TRUE(diff_logs(*original, *log)->identical());
}

TEST(Recover, WithoutItsHeaderALogReplays) {
  for (const sim::Method method : kMethods) {
    const Bytes bytes = record_to_memory(scene_with_inputs(24, method), {}, 6);
    const Result<LogReader> original = open_memory(bytes);
    for (const std::size_t first : {0U, 1U}) {
      const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(original->chunks()[first].offset);
      const Result<RecoveredLog> recovered = recover_memory(Bytes(begin, bytes.end()));
      ASSERT_TRUE(recovered.ok()) << recovered.error().message;
      EXPECT_TRUE(recovered->report.header_lost);
      EXPECT_EQ(recovered->report.first_state, 6 * first);
      Result<LogReader> log = open_memory(recovered->bytes);
      EXPECT_EQ(log->header().phases, original->header().phases);
      EXPECT_EQ(log->header().states, original->header().states);
      const Result<ReplayReport> replayed = replay_log(*log);
      ASSERT_TRUE(replayed.ok()) << replayed.error().message;
      EXPECT_TRUE(replayed->identical()) << describe(*replayed->first);
      EXPECT_EQ(replayed->steps, 24 - 6 * first);
    }
  }
}

TEST(Recover, WhatWasRecoveredCanBeDamagedAndRecoveredAgain) {
  const SampleLog& s = sample_log();
  const Result<RecoveredLog> once = recover_memory(s.joined({0, 1, 3, 4, 5, 6}));
  ASSERT_TRUE(once.ok());
  const Result<RecoveredLog> same = recover_memory(once->bytes);
  ASSERT_TRUE(same.ok()) << same.error().message;
  EXPECT_EQ(same->report.lost, Gaps{steps_of(2)});
  Bytes bytes = once->bytes;
  const Result<LogReader> log = open_memory(bytes);
  bytes[log->chunks()[1].offset + kPreludeBytes + 30] ^= std::byte{4};
  const Result<RecoveredLog> twice = recover_memory(bytes);
  ASSERT_TRUE(twice.ok()) << twice.error().message;
  EXPECT_EQ(twice->report.lost, (Gaps{{7, 12}}));
  expect_recorded_steps(twice->bytes, twice->report.lost);
}

TEST(Recover, WhereNothingIsLeftItSaysSo) {
  const Result<RecoveredLog> header_only = recover_memory(sample_log().record(0));
  ASSERT_FALSE(header_only.ok());
  EXPECT_EQ(header_only.error().kind, ErrorKind::kDamaged);
  EXPECT_NE(header_only.error().message.find("not one whole chunk"), std::string::npos);
  const Result<RecoveredLog> other = recover_memory(Bytes(500, std::byte{'a'}));
  ASSERT_FALSE(other.ok());
  EXPECT_EQ(other.error().kind, ErrorKind::kBadInput);
  EXPECT_NE(other.error().message.find("is not a log"), std::string::npos);
}

}  // namespace
}  // namespace tumble::replay
