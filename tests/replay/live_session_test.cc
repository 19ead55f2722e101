// A session that is played: inputs at any time, pauses, returns; every log of it replays to the bit.
#include "replay/live/live_session.h"

#include <gtest/gtest.h>
#include <xmmintrin.h>

#include <chrono>
#include <filesystem>
#include <set>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "replay/live/live_inputs.h"
#include "src/world/float_environment.h"
#include "tests/support/sim_scenes.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/replayer.h"

namespace tumble::replay {
namespace {

namespace fs = std::filesystem;

class LiveSessionTest : public testing::Test {
 public:
  LiveSessionTest()
      : folder_(fs::temp_directory_path() / ("tumble_live_" + std::to_string(::getpid()) + "_" + name())) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~LiveSessionTest() override { fs::remove_all(folder_); }
  LiveSessionTest(const LiveSessionTest&) = delete;
  LiveSessionTest& operator=(const LiveSessionTest&) = delete;

 protected:
  static std::string name() { return testing::UnitTest::GetInstance()->current_test_info()->name(); }

  // Steps as fast as the clock of 1000 steps a second allows, so that a test takes no longer than it must.
  [[nodiscard]] LiveOptions options(const sim::SceneDef& scene) const {
    LiveOptions options;
    options.log = (folder_ / "played.tumble").string();
    options.begin = [scene](const std::string& path) { return Recorder::start(path, scene, {}); };
    options.dt = scene.world.dt;
    options.pace.even = true;
    return options;
  }

  static sim::SceneDef scene() {
    sim::SceneDef scene = test::tower(4);
    scene.world.dt = 1.0 / 1000;
    return scene;
  }

  static LiveFrame frame_at(LiveSession& session, std::uint64_t step) {
    LiveFrame frame;
    while (frame.step < step && frame.ended.empty()) {
      session.wait_for_newer(frame.serial, 1);
      session.take(frame);
    }
    return frame;
  }
  static LiveFrame frame_with(LiveSession& session, std::uint64_t inputs) {
    LiveFrame frame;
    while (frame.inputs_done < inputs && frame.ended.empty()) {
      session.wait_for_newer(frame.serial, 1);
      session.take(frame);
    }
    return frame;
  }

  fs::path folder_;
};

sim::Throw thrown(double x) {
  sim::BoxDef box = test::cube(0, {x, -6, 1});
  box.velocity = {0, 12, 0};
  return {box};
}

std::vector<sim::TimedCommand> inputs_of(const std::string& path) {
  Result<LogReader> log = LogReader::open(path);
  std::vector<sim::TimedCommand> inputs;
  for (std::uint64_t k = log->first_state() + 1; k <= log->last_step(); ++k) {
    for (const sim::Command& input : (*log->read_hashes(k))->inputs) inputs.push_back({k, input});
  }
  return inputs;
}

template <class Input>
std::size_t count(const std::string& path) {
  std::size_t found = 0;
  for (const sim::TimedCommand& input : inputs_of(path))
    found += std::holds_alternative<Input>(input.command) ? 1U : 0U;
  return found;
}

void expect_replays(const std::string& path) {
  Result<LogReader> log = LogReader::open(path);
  ASSERT_TRUE(log.ok()) << log.error().message;
  const LogCondition& condition = log->condition();
  EXPECT_TRUE(condition.whole()) << path;
  const Result<ReplayReport> report = replay_log(*log);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_TRUE(report->identical()) << path;
}

TEST_F(LiveSessionTest, LogsEveryInputAndReplaysToTheBit) {
  auto session = LiveSession::start(options(scene()));
  ASSERT_TRUE(session.ok());
  frame_at(**session, 20);
  (*session)->post(thrown(0));
  (*session)->post(sim::Push{2, {0, 0.5, 0}, true, {}});
  (*session)->post(sim::SetGravity{{0, 0, -3}});
  frame_with(**session, (*session)->post(sim::Remove{4}));
  frame_with(**session, (*session)->post(sim::Wake{1}));
  const auto logs = (*session)->finish();
  ASSERT_TRUE(logs.ok());
  ASSERT_EQ(logs->size(), 1U);
  const std::string path = logs->front().path;
  EXPECT_EQ(inputs_of(path).size(), 5U);
  EXPECT_EQ(count<sim::Throw>(path), 1U);
  expect_replays(path);
}

TEST_F(LiveSessionTest, AnInputThatTheWorldRefusesEndsNothing) {
  auto session = LiveSession::start(options(scene()));
  ASSERT_TRUE(session.ok());
  (*session)->post(sim::Remove{77});
  const LiveFrame frame = frame_with(**session, (*session)->post(thrown(1)));
  EXPECT_NE(frame.notice.find("found id 77"), std::string::npos) << frame.notice;
  EXPECT_TRUE(frame.ended.empty());
  const auto logs = (*session)->finish();
  EXPECT_EQ(inputs_of(logs->front().path).size(), 1U) << "the refused input is in the log";
}

TEST_F(LiveSessionTest, NoIdComesTwice) {
  auto session = LiveSession::start(options(scene()));
  ASSERT_TRUE(session.ok());
  LiveFrame frame = frame_with(**session, (*session)->post(thrown(0)));
  const std::uint64_t first = frame.snapshot.boxes.back().id;
  frame_with(**session, (*session)->post(sim::Remove{first}));
  frame = frame_with(**session, (*session)->post(thrown(0)));
  EXPECT_GT(frame.snapshot.boxes.back().id, first);
  EXPECT_EQ(frame.snapshot.boxes.size(), 5U);
}

TEST_F(LiveSessionTest, APauseStopsStepsAndKeepsInputsForTheNext) {
  auto session = LiveSession::start(options(scene()));
  ASSERT_TRUE(session.ok());
  frame_at(**session, 5);
  (*session)->set({.paused = true, .speed = 1, .even = true});
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  LiveFrame paused;
  (*session)->take(paused);
  const std::uint64_t inputs = (*session)->post(thrown(0));
  EXPECT_FALSE((*session)->wait_for_newer(paused.serial, 0.05)) << "a paused session stepped";
  // What was played is in the file before a pause, so a crash loses nothing of it.
  Result<LogReader> open = LogReader::open((folder_ / "played.tumble").string());
  ASSERT_TRUE(open.ok());
  EXPECT_EQ(open->last_step(), paused.step);
  (*session)->step_once();
  const LiveFrame after = frame_with(**session, inputs);
  EXPECT_EQ(after.step, paused.step + 1);
  EXPECT_EQ(after.snapshot.boxes.size(), 5U);
  const auto logs = (*session)->finish();
  EXPECT_EQ(logs->front().summary.steps, paused.step + 1);
}

TEST_F(LiveSessionTest, SlowMotionTakesShorterStepsOrFewer) {
  sim::SceneDef slow = scene();
  slow.world.dt = 1.0 / 200;
  LiveOptions how = options(slow);
  how.pace = {.paused = false, .speed = 0.125, .even = false};
  auto session = LiveSession::start(how);
  ASSERT_TRUE(session.ok());
  const LiveFrame frame = frame_at(**session, 20);
  EXPECT_LT(frame.dt, slow.world.dt / 2 + 1e-12) << "four frames of lateness at an eighth of the speed";
  const auto logs = (*session)->finish();
  EXPECT_GT(count<sim::SetDt>(logs->front().path), 10U) << "the lengths of steps are inputs";
  expect_replays(logs->front().path);
  const LivePacer even(0.01, {.paused = false, .speed = 0.5, .even = true}, 3);
  LivePacer pacer = even;
  EXPECT_EQ(pacer.begin(3), 0.01);
  EXPECT_DOUBLE_EQ(pacer.due(), 3.02);
}

TEST_F(LiveSessionTest, GoesBackIntoANewLogWithoutTheHandsInputs) {
  sim::SceneDef planned = scene();
  planned.steps = 5000;
  planned.inputs.push_back({4000, sim::SetGravity{{0, 0, -1}}});
  auto session = LiveSession::start(options(planned));
  ASSERT_TRUE(session.ok());
  frame_at(**session, 60);
  frame_with(**session, (*session)->post(thrown(0)));
  const LiveFrame before = frame_at(**session, 90);
  (*session)->back(0.05);  // 50 steps
  LiveFrame frame = before;
  while (frame.log == before.log) {
    (*session)->wait_for_newer(frame.serial, 1);
    (*session)->take(frame);
  }
  frame_at(**session, frame.step + 10);
  (*session)->back(1000);  // further back than the new log goes, and than there is anything
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  const auto logs = (*session)->finish();
  ASSERT_TRUE(logs.ok()) << logs.error().message;
  ASSERT_EQ(logs->size(), 3U);
  EXPECT_GT((*logs)[1].first_state, 10U);
  EXPECT_LT((*logs)[1].first_state, 90U);
  EXPECT_EQ((*logs)[1].path,
            (folder_ / ("played_from_" + std::to_string((*logs)[1].first_state) + ".tumble")).string());
  EXPECT_EQ((*logs)[2].first_state, 0U) << "the first log's start";
  EXPECT_EQ(count<sim::Throw>((*logs)[1].path), 0U);
  Result<LogReader> again = LogReader::open((*logs)[1].path);
  ASSERT_EQ(again->header().scene.inputs.size(), 1U) << "what the scene plans stays";
  EXPECT_EQ(again->header().scene.inputs.front().step, 4000U);
  for (const SavedLog& log : *logs) expect_replays(log.path);
}

TEST_F(LiveSessionTest, BeginsAgainAndReplacesNoLog) {
  auto session = LiveSession::start(options(scene()));
  ASSERT_TRUE(session.ok());
  frame_at(**session, 10);
  for (int k = 0; k < 2; ++k) {
    LiveFrame frame;
    (*session)->take(frame);
    const std::string log = frame.log;
    (*session)->again();
    while (frame.log == log || frame.step < 3) {
      (*session)->wait_for_newer(frame.serial, 1);
      (*session)->take(frame);
    }
  }
  const auto logs = (*session)->finish();
  ASSERT_EQ(logs->size(), 3U);
  std::set<std::string> paths;
  for (const SavedLog& log : *logs) {
    paths.insert(log.path);
    expect_replays(log.path);
  }
  EXPECT_EQ(paths.size(), 3U);
}

TEST_F(LiveSessionTest, AStepThatFailsLeavesAWholeLogAndAWayBack) {
  sim::SceneDef doomed = scene();
  auto session = LiveSession::start(options(doomed));
  ASSERT_TRUE(session.ok());
  frame_at(**session, 30);
  sim::BoxDef box = test::cube(0, {0, 0, 32767});
  box.velocity = {0, 0, 8000};
  (*session)->post(sim::Throw{box});
  LiveFrame frame;
  while (frame.ended.empty()) {
    (*session)->wait_for_newer(frame.serial, 1);
    (*session)->take(frame);
  }
  EXPECT_NE(frame.ended.find("step"), std::string::npos) << frame.ended;
  (*session)->back(0.01);
  while (!frame.ended.empty()) {
    (*session)->wait_for_newer(frame.serial, 1);
    (*session)->take(frame);
  }
  const auto logs = (*session)->finish();
  ASSERT_TRUE(logs.ok());
  ASSERT_EQ(logs->size(), 2U);
  expect_replays(logs->front().path);
}

// The threads of a session, which step and write, inherit the environment of the one that starts them: where a driver
// has switched on flush-to-zero, that is where they would get it from.
TEST_F(LiveSessionTest, RestoresTheFloatingPointEnvironment) {
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | 0x8040U);  // flush to zero, denormals are zero
  auto session = LiveSession::start(options(scene()));
  _mm_setcsr(before);
  ASSERT_TRUE(session.ok());
  const LiveFrame frame = frame_at(**session, 10);
  EXPECT_EQ(frame.restored, 1U);
  const auto logs = (*session)->finish();
  expect_replays(logs->front().path);
}

TEST_F(LiveSessionTest, ReportsEachPhase) {
  auto session = LiveSession::start(options(scene()));
  ASSERT_TRUE(session.ok());
  const LiveFrame frame = frame_at(**session, 10);
  ASSERT_EQ(frame.phase_names.size(), sim::phase_table(scene().world.method).phases.size());
  double sum = frame.hash_seconds;
  for (const double seconds : frame.phase_seconds) {
    EXPECT_GE(seconds, 0);
    sum += seconds;
  }
  EXPECT_LE(sum, frame.step_seconds);
}

}  // namespace
}  // namespace tumble::replay
