// Writing: full disks, short writes, a writer that never finishes, files that must not be lost.
#include "tumble/replay/log_writer.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <thread>

#include "replay/format/limits.h"
#include "replay/log/verify.h"
#include "tests/support/log_memory.h"

namespace tumble::replay {
namespace {

/// Records onto `disk` until an error; returns it, or success.
Status record_on(const std::shared_ptr<Disk>& disk, const sim::SceneDef& scene, std::uint64_t flush_every) {
  auto recorder = Recorder::start(std::make_unique<MemorySink>(disk), scene, {});
  if (!recorder.ok()) return recorder.error();
  for (std::uint64_t k = 1; k <= scene.steps; ++k) {
    if (Status ok = (*recorder)->step(); !ok.ok()) return ok;
    if (k % flush_every != 0) continue;
    if (Status ok = (*recorder)->flush(); !ok.ok()) return ok;
  }
  Result<LogSummary> summary = (*recorder)->finish();
  if (!summary.ok()) return summary.error();
  return {};
}

TEST(LogWriter, AFullDiskLosesNoCompleteChunk) {
  const sim::SceneDef scene = scene_with_inputs(24);
  const Bytes whole = record_to_memory(scene, {}, 6);
  const Result<LogReader> reference = open_memory(whole);
  ASSERT_TRUE(reference.ok());
  for (std::uint64_t capacity = 0; capacity < whole.size(); capacity += 13) {
    SCOPED_TRACE("room for " + std::to_string(capacity) + " bytes");
    const auto disk = std::make_shared<Disk>();
    disk->capacity = capacity;
    const Status status = record_on(disk, scene, 6);
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.error().kind, ErrorKind::kCannotFinish);
    EXPECT_NE(status.error().message.find("memory.tumble"), std::string::npos) << status.error().message;
    EXPECT_NE(status.error().message.find("No space left"), std::string::npos) << status.error().message;
    std::size_t complete = 0;
    for (const ChunkPlace& place : reference->chunks()) complete += place.offset + place.length <= capacity ? 1 : 0;
    if (disk->bytes.empty()) continue;  // not even the header
    Result<LogReader> log = open_memory(disk->bytes);
    ASSERT_TRUE(log.ok()) << log.error().message;
    EXPECT_EQ(log->chunks().size(), complete);
    EXPECT_FALSE(log->condition().finished);
    EXPECT_EQ(log->condition().torn_offset, log->file_bytes()) << "half a record was left behind";
    EXPECT_TRUE(verify(*log).condition.damages.empty());
    if (complete > 0) {
      const std::string saved = "steps 1 to " + std::to_string(complete * 6) + " are saved";
      EXPECT_NE(status.error().message.find(saved), std::string::npos) << status.error().message;
    }
  }
}

TEST(LogWriter, ShortWritesChangeNothing) {
  const sim::SceneDef scene = scene_with_inputs(24);
  const Bytes whole = record_to_memory(scene, {}, 6);
  for (const std::size_t write_max : {1U, 7U, 100U}) {
    const auto disk = std::make_shared<Disk>();
    disk->write_max = write_max;
    ASSERT_TRUE(record_on(disk, scene, 6).ok());
    EXPECT_EQ(disk->bytes, whole);
  }
}

TEST(LogWriter, ALogThatCannotReachTheDiskDoesNotLookFinished) {
  const auto disk = std::make_shared<Disk>();
  disk->sync_fails = true;
  const Status status = record_on(disk, small_scene(), 6);
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.error().message.find("Input/output error"), std::string::npos);
  const Result<LogReader> log = open_memory(disk->bytes);
  ASSERT_TRUE(log.ok());
  EXPECT_FALSE(log->condition().finished);
  EXPECT_EQ(log->step_count(), 20U);
}

TEST(LogWriter, DroppedWithoutFinishItsStepsCanBeRead) {
  const sim::SceneDef scene = small_scene();
  const auto disk = std::make_shared<Disk>();
  {
    auto recorder = Recorder::start(std::make_unique<MemorySink>(disk), scene, {});
    ASSERT_TRUE(recorder.ok());
    for (int k = 0; k < 10; ++k) ASSERT_TRUE((*recorder)->step().ok());
    ASSERT_TRUE((*recorder)->flush().ok());
    const Result<LogReader> meanwhile = open_memory(disk->bytes);
    ASSERT_TRUE(meanwhile.ok());
    EXPECT_EQ(meanwhile->step_count(), 10U);
    ASSERT_TRUE((*recorder)->step().ok());
  }
  Result<LogReader> log = open_memory(disk->bytes);
  ASSERT_TRUE(log.ok());
  EXPECT_TRUE(log->condition().torn);
  EXPECT_EQ(log->step_count(), 11U);
  EXPECT_TRUE(verify(*log).condition.damages.empty());
}

/// Bodies at rest, each by itself.
sim::SceneDef quiet_scene(std::uint64_t steps) {
  sim::SceneDef quiet = small_scene(steps);
  for (sim::BoxDef& box : quiet.boxes) {
    box.frozen = true;
    box.spin = {0, 0, 0};
    box.position = {10.0 * static_cast<double>(box.id), 0, box.size.z() / 2};
  }
  return quiet;
}

TEST(LogWriter, ChunksCloseByThemselves) {
  sim::SceneDef scene = small_scene(600);
  scene.world.freezing = false;
  scene.boxes[0].frozen = false;
  const Result<LogReader> busy = open_memory(record_to_memory(scene));
  ASSERT_TRUE(busy.ok());
  EXPECT_EQ(busy->chunks()[0].step_count, kChunkBusySteps);
  const Result<LogReader> log = open_memory(record_to_memory(quiet_scene(600)));
  ASSERT_TRUE(log.ok());
  EXPECT_EQ(log->chunks()[0].step_count, kChunkStepsMax);
}

TEST(LogWriter, ASlowSessionIsWrittenEverySecond) {
  const auto disk = std::make_shared<Disk>();
  auto recorder = Recorder::start(std::make_unique<MemorySink>(disk), small_scene(), {});
  ASSERT_TRUE(recorder.ok());
  ASSERT_TRUE((*recorder)->step().ok());
  std::this_thread::sleep_for(std::chrono::milliseconds(1050));
  ASSERT_TRUE((*recorder)->step().ok());  // closes the chunk that was begun a second ago
  ASSERT_TRUE((*recorder)->step().ok());
  ASSERT_TRUE((*recorder)->finish().ok());
  const Result<LogReader> log = open_memory(disk->bytes);
  ASSERT_TRUE(log.ok());
  ASSERT_EQ(log->chunks().size(), 2U);
  EXPECT_EQ(log->chunks()[0].step_count, 2U);
}

TEST(LogWriter, AFileThatIsNoLogIsNotOverwritten) {
  const std::string path = testing::TempDir() + "/precious.toml";
  std::ofstream(path) << "name = \"mine\"\n";
  const Result<LogSummary> refused = record_session(path, small_scene(), {});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().kind, ErrorKind::kBadInput);
  std::stringstream content;
  content << std::ifstream(path).rdbuf();
  EXPECT_EQ(content.str(), "name = \"mine\"\n");
  std::remove(path.c_str());
  ASSERT_TRUE(record_session(path, small_scene(), {}).ok());
  EXPECT_TRUE(record_session(path, small_scene(5), {}).ok()) << "a log may be";
  const Result<LogReader> log = LogReader::open(path);
  ASSERT_TRUE(log.ok());
  EXPECT_EQ(log->step_count(), 5U);
  std::remove(path.c_str());
  EXPECT_FALSE(record_session(testing::TempDir(), small_scene(), {}).ok());
  EXPECT_FALSE(record_session("/no/such/folder/x.tumble", small_scene(), {}).ok());
}

TEST(LogWriter, TheSystemsFullDeviceIsReported) {
  std::FILE* full = std::fopen("/dev/full", "r");
  if (full == nullptr) GTEST_SKIP() << "no /dev/full here";
  std::fclose(full);
  const Result<LogSummary> summary = record_session("/dev/full", small_scene(), {});
  ASSERT_FALSE(summary.ok());
  EXPECT_EQ(summary.error().kind, ErrorKind::kCannotFinish);
  EXPECT_NE(summary.error().message.find("/dev/full"), std::string::npos);
}

/// A writer whose log begins with state 0 of the small scene.
std::unique_ptr<LogWriter> writer_in_memory(sim::WorldState& state) {
  const sim::SceneDef scene = small_scene();
  state = sim::create_world(scene)->state();
  return *LogWriter::create(std::make_unique<MemorySink>(std::make_shared<Disk>()), header_for(scene), state);
}

TEST(LogWriterDeathTest, AStepMustFollowTheStepBefore) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  sim::WorldState state;
  const std::unique_ptr<LogWriter> writer = writer_in_memory(state);
  state.step = 2;
  EXPECT_EXIT((void)writer->append({}, state), testing::ExitedWithCode(4), "log_writer.cc:.*found .* = 2, 0");
}

TEST(LogWriterDeathTest, IsFinishedOnce) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  sim::WorldState state;
  const std::unique_ptr<LogWriter> writer = writer_in_memory(state);
  EXPECT_TRUE(writer->finish().ok());
  EXPECT_EXIT((void)writer->finish().ok(), testing::ExitedWithCode(4), "internal check failed: !shared_->finished");
}

TEST(Recorder, AStepThatFailsLeavesACompleteLog) {
  sim::SceneDef scene = small_scene(20);
  scene.inputs = {{8, sim::Remove{4711}}};
  const std::string path = testing::TempDir() + "/ended_early.tumble";
  const Result<LogSummary> summary = record_session(path, scene, {});
  ASSERT_FALSE(summary.ok());
  EXPECT_NE(summary.error().message.find("before step 8"), std::string::npos) << summary.error().message;
  EXPECT_NE(summary.error().message.find("7 steps"), std::string::npos) << summary.error().message;
  const Result<LogReader> log = LogReader::open(path);
  ASSERT_TRUE(log.ok());
  EXPECT_EQ(log->step_count(), 7U);
  EXPECT_TRUE(log->condition().whole());
  std::remove(path.c_str());
}

// Between chunks the writer makes room for longer ones.
TEST(LogWriter, LongChunksOfRestingBodiesComeBack) {
  const sim::SceneDef scene = quiet_scene(420);
  const std::vector<BodyStates> wanted = simulate(scene);
  for (const std::uint64_t flush_every : {65U, 100U, 140U}) {
    Result<LogReader> log = open_memory(record_to_memory(scene, {}, flush_every));
    ASSERT_TRUE(log.ok()) << log.error().message;
    EXPECT_EQ(log->chunks()[0].step_count, flush_every);
    EXPECT_TRUE(verify(*log).condition.whole());
    for (std::uint64_t k = 1; k <= scene.steps; ++k) {
      ASSERT_TRUE(same_bits((*log->read_step(k))->states, wanted[k])) << "step " << k;
    }
  }
}

}  // namespace
}  // namespace tumble::replay
