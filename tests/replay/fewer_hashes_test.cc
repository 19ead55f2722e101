// Logs that hold phase words of some steps or of none: what is there is compared, and what is not is named.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "replay/log/record_reader.h"
#include "replay/log/verify.h"
#include "tests/replay/lying_log.h"
#include "tests/support/log_memory.h"
#include "tests/support/sample_log.h"
#include "tumble/replay/compare.h"
#include "tumble/replay/replayer.h"

namespace tumble::replay {
namespace {

Bytes recorded(const sim::SceneDef& scene, std::uint32_t every, std::uint64_t flush_every = 1000) {
  RecordOptions options;
  options.hashes = {every};
  return record_to_memory(scene, options, flush_every);
}

ReplayReport replay_of(const Bytes& bytes) {
  Result<LogReader> log = open_memory(bytes);
  EXPECT_TRUE(log.ok());
  Result<ReplayReport> report = replay_log(*log);
  EXPECT_TRUE(report.ok()) << report.error().message;
  return *std::move(report);
}

DiffReport diff_of(const Bytes& bytes_a, const Bytes& bytes_b) {
  Result<LogReader> a = open_memory(bytes_a);
  Result<LogReader> b = open_memory(bytes_b);
  EXPECT_TRUE(a.ok() && b.ok());
  Result<DiffReport> report = diff_logs(*a, *b);
  EXPECT_TRUE(report.ok()) << report.error().message;
  return *std::move(report);
}

bool has(const std::vector<std::string>& parts, const std::string& part) { return std::ranges::count(parts, part) > 0; }

constexpr const char* kAll = "phase hashes";
constexpr const char* kLeftOut30 = "phase hashes of 30 steps, which a log does not hold";
constexpr const char* kLeftOut40 = "phase hashes of 40 steps, which a log does not hold";

TEST(HashesMode, WordsAreReadAndWritten) {
  for (const std::string text : {"all", "states", "every:2", "every:4294967295"}) {
    const Result<HashesMode> mode = parse_hashes_mode(text);
    ASSERT_TRUE(mode.ok()) << text;
    EXPECT_EQ(to_string(*mode), text);
  }
  for (const std::string text : {"", "hashes", "every:", "every:0", "every:-1", "every:1x", "every:4294967296"}) {
    const Result<HashesMode> mode = parse_hashes_mode(text);
    ASSERT_FALSE(mode.ok()) << text;
    EXPECT_EQ(mode.error().kind, ErrorKind::kBadInput);
    EXPECT_NE(mode.error().message.find("every:N"), std::string::npos);
  }
}

TEST(FewerHashes, OnlyPhaseWordsAreMissing) {
  for (const sim::Method method : kMethods) {
    const sim::SceneDef scene = scene_with_inputs(40, method);
    Result<LogReader> whole = open_memory(record_to_memory(scene, {}, 7));
    for (const std::uint32_t every : {0U, 1U, 4U}) {
      Result<LogReader> log = open_memory(recorded(scene, every, 7));
      ASSERT_TRUE(log.ok()) << log.error().message;
      EXPECT_EQ(log->header().hashes, HashesMode{every});
      EXPECT_TRUE(verify(*log).condition.whole());
      for (std::uint64_t k = 1; k <= 40; ++k) {
        const StepRecord wanted = **whole->read_step(k);
        const StepRecord found = **log->read_step(k);
        const bool held = every != 0 && k % every == 0;
        EXPECT_EQ(found.phase_words, held ? wanted.phase_words : Words()) << k;
        EXPECT_EQ(found.state_hash, wanted.state_hash) << k;
        EXPECT_EQ(found.counters, wanted.counters) << k;
        EXPECT_TRUE(same_bits(found.states, wanted.states)) << k;
      }
    }
  }
}

TEST(FewerHashes, AReplayTellsWhatItDidNotCompare) {
  const sim::SceneDef scene = scene_with_inputs();
  const ReplayReport all = replay_of(recorded(scene, 1));
  EXPECT_TRUE(all.identical() && has(all.scope.compared, kAll));
  const ReplayReport some = replay_of(recorded(scene, 4, 7));
  EXPECT_TRUE(some.identical()) << describe(*some.first);
  EXPECT_TRUE(has(some.scope.compared, "phase hashes of 10 steps"));
  EXPECT_TRUE(has(some.scope.not_compared, kLeftOut30));
  EXPECT_FALSE(has(some.scope.compared, kAll));
  const ReplayReport none = replay_of(recorded(scene, 0, 7));
  EXPECT_TRUE(none.identical()) << describe(*none.first);
  EXPECT_TRUE(has(none.scope.not_compared, kLeftOut40));
  EXPECT_TRUE(has(none.scope.compared, "state hashes"));
}

TEST(FewerHashes, ADiffTellsWhatItDidNotCompare) {
  const Bytes whole = recorded(scene_with_inputs(), 1, 9);
  for (const std::uint64_t flush_every : {9U, 7U}) {
    const Bytes some = recorded(scene_with_inputs(), 4, flush_every);
    for (const auto& [a, b] : {std::pair(&whole, &some), std::pair(&some, &whole), std::pair(&some, &some)}) {
      const DiffReport report = diff_of(*a, *b);
      EXPECT_TRUE(report.identical()) << describe(*report.first);
      EXPECT_TRUE(has(report.scope.compared, "phase hashes of 10 steps"));
      EXPECT_TRUE(has(report.scope.not_compared, kLeftOut30));
    }
    const DiffReport report = diff_of(some, recorded(scene_with_inputs(), 0));
    EXPECT_TRUE(report.identical());
    EXPECT_TRUE(has(report.scope.not_compared, kLeftOut40));
    EXPECT_FALSE(has(report.scope.compared, kAll));
  }
  EXPECT_TRUE(has(diff_of(whole, whole).scope.compared, kAll));
}

TEST(FewerHashes, AnotherStateIsFoundInAStepWithoutWords) {
  const auto change = [](sim::WorldState& state, Words&, sim::StepCounters&) {
    state.bodies.velocity.y[1] = std::nextafter(state.bodies.velocity.y[1], 100.0);
  };
  const sim::SceneDef scene = small_scene();
  const Bytes lie = record_with_lie(scene, 7, change);
  for (const std::uint32_t every : {0U, 4U}) {
    const DiffReport report = diff_of(recorded(scene, every), lie);
    ASSERT_TRUE(report.first) << every;
    EXPECT_EQ(report.first->step, 7U);
    EXPECT_EQ(report.first->phase, "step");
    EXPECT_EQ(report.first->field, "velocity.y");
    EXPECT_EQ(report.first->body, 11U);
  }
}

TEST(FewerHashes, AnotherWordIsFoundInAStepThatBothHold) {
  const sim::SceneDef scene = small_scene();
  const auto change = [](sim::WorldState&, Words& words, sim::StepCounters&) { words[2] ^= 1; };
  const Bytes some = recorded(scene, 4);
  const DiffReport found = diff_of(record_with_lie(scene, 8, change), some);
  ASSERT_TRUE(found.first);
  EXPECT_EQ(found.first->step, 8U);
  EXPECT_EQ(found.first->phase, header_for(scene).phases[2]);
  EXPECT_EQ(found.first->field, "phase_hash");
  const DiffReport passed_over = diff_of(record_with_lie(scene, 7, change), some);
  EXPECT_TRUE(passed_over.identical());
  EXPECT_TRUE(has(passed_over.scope.not_compared, "phase hashes of 15 steps, which a log does not hold"));
}

TEST(FewerHashes, AContinuedLogHasItsOwnMode) {
  const sim::SceneDef scene = scene_with_inputs();
  const Bytes whole = recorded(scene, 1, 9);
  Result<LogReader> from = open_memory(whole);
  const auto disk = std::make_shared<Disk>();
  GoOnOptions how;
  how.hashes = {5};
  auto recorder = Recorder::go_on(std::make_unique<MemorySink>(disk), *from, 12, how);
  ASSERT_TRUE(recorder.ok()) << recorder.error().message;
  ASSERT_TRUE((*recorder)->run().ok());
  ASSERT_TRUE((*recorder)->finish().ok());
  Result<LogReader> log = open_memory(disk->bytes);
  EXPECT_TRUE((*log->read_step(14))->phase_words.empty());
  EXPECT_EQ((*log->read_step(15))->phase_words, (*from->read_step(15))->phase_words);
  EXPECT_TRUE(replay_of(disk->bytes).identical());
  EXPECT_TRUE(diff_of(whole, disk->bytes).first == std::nullopt);
}

TEST(FewerHashes, ALostHeaderIsMadeFromTheSteps) {
  for (const std::uint32_t every : {0U, 4U}) {
    const Bytes bytes = recorded(scene_with_inputs(24), every, 6);
    const Result<LogReader> original = open_memory(bytes);
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(original->chunks()[0].offset);
    const Result<RecoveredLog> recovered = recover_memory(Bytes(begin, bytes.end()));
    ASSERT_TRUE(recovered.ok()) << recovered.error().message;
    Result<LogReader> log = open_memory(recovered->bytes);
    EXPECT_EQ(log->header().hashes, HashesMode{every});
    EXPECT_TRUE(replay_of(recovered->bytes).identical());
  }
}

TEST(FewerHashes, WordsThatTheHeaderDeniesAreDamage) {
  const MemorySource source(recorded(small_scene(), 1));
  Result<LogReader> log = LogReader::open(std::make_unique<MemorySource>(source));
  ASSERT_TRUE(log.ok());
  ChunkRules rules = {.log_tag = log->header_prelude().log_tag, .phase_count = log->header().phases.size()};
  EXPECT_TRUE(RecordReader(source).read_chunk(log->chunks()[0], rules).ok());
  rules.hashes = {4};
  const Result<ChunkDecoder> chunk = RecordReader(source).read_chunk(log->chunks()[0], rules);
  ASSERT_FALSE(chunk.ok());
  EXPECT_EQ(chunk.error().kind, ErrorKind::kDamaged);
  EXPECT_NE(chunk.error().message.find("step 1 has"), std::string::npos) << chunk.error().message;
  EXPECT_NE(chunk.error().message.find("every:4"), std::string::npos) << chunk.error().message;
}

}  // namespace
}  // namespace tumble::replay
