// Logs of other engines: facts and states that no log can keep, or that no body can have, are refused when they are
// told.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "replay/log/byte_memory.h"
#include "replay/log/verify.h"
#include "tumble/replay/comparison_scope.h"
#include "tumble/replay/engine_log.h"
#include "tumble/replay/engine_log_c.h"

namespace tumble::replay {
namespace {

sim::BoxDef cube(sim::BodyId id, const sim::Quat& orientation = {}) {
  sim::BoxDef box;
  box.id = id;
  box.orientation = orientation;
  return box;
}

Result<std::unique_ptr<EngineLog>> log_of(const sim::BoxDef& box, const std::optional<ImportedTable>& table = {}) {
  sim::SceneDef start;
  start.name = "drop";
  start.boxes = {box};
  auto sink = std::make_unique<MemoryByteSink>(std::make_shared<std::vector<std::byte>>(), "toy.tumble");
  return EngineLog::create(std::move(sink), {{"toy", "1"}, {}, table}, start);
}

TEST(EngineLogRefusal, OfATableThatNoLogCanKeep) {
  const double nan = std::nan("");
  const std::vector<std::string> many(2000, "_c");
  for (const ImportedTable& table :
       {ImportedTable{{7, false, 1}, {}}, ImportedTable{{-1, false, 1}, {}}, ImportedTable{{2, false, nan}, {}},
        ImportedTable{{2, false, 0}, {}}, ImportedTable{{2, false, 1}, many}}) {
    const auto log = log_of(cube(1), table);
    ASSERT_FALSE(log.ok()) << "a whole log would be written that no reader opens";
    EXPECT_EQ(log.error().kind, ErrorKind::kBadInput);
  }
}

TEST(EngineLogRefusal, OfAnOrientationThatIsNoRotation) {
  const auto made = log_of(cube(1));
  ASSERT_TRUE(made.ok()) << made.error().message;
  EngineLog& log = **made;
  EngineState state;
  for (const sim::Quat& q : {sim::Quat{0, 0, 0, 0}, sim::Quat{2, 0, 0, 0}, sim::Quat{0.98, 0, 0, 0}}) {
    state.orientation = q;
    const Status set = log.set_state(1, state);
    ASSERT_FALSE(set.ok());
    EXPECT_EQ(set.error().kind, ErrorKind::kBadInput);
    EXPECT_NE(set.error().message.find("step 1: body 1: found an orientation of length"), std::string::npos)
        << set.error().message;
    EXPECT_FALSE(log.input(sim::Throw{cube(7, q)}).ok());
    EXPECT_FALSE(log_of(cube(1, q)).ok());
  }
  state.orientation = {std::nan(""), 0, 0, 0};
  EXPECT_TRUE(log.set_state(1, state).ok()) << "a body that is lost";
  ASSERT_TRUE(log.end_step(0.01).ok());
  state.orientation = {1.005, 0, 0, 0};
  EXPECT_TRUE(log.set_state(1, state).ok()) << "within the bound";
}

TEST(EngineLogRefusal, OfAnOrientationThatAProgramInCForgot) {
  TumbleLog* log = tumble_log_new("C engine", "0.1");
  TumbleLogBody body = {};
  body.id = 1;
  body.size[0] = body.size[1] = body.size[2] = body.mass = 1;
  body.state.orientation[0] = 1;
  TumbleLogStart start = {};
  start.dt = 0.5;
  start.precision_bits = kBinary32Bits;
  tumble_log_add_body(log, &body);
  const std::string path = ::testing::TempDir() + "engine_log_no_rotation.tumble";
  EXPECT_EQ(tumble_log_begin(log, path.c_str(), &start), TUMBLE_OK) << tumble_log_message(log);
  const TumbleLogState forgotten = {};
  EXPECT_EQ(tumble_log_set_state(log, 1, &forgotten), TUMBLE_BAD_INPUT);
  EXPECT_NE(std::string(tumble_log_message(log)).find("found an orientation of length 0"), std::string::npos);
  const Result<LogReader> left = LogReader::open(path);  // though the program may end here
  ASSERT_TRUE(left.ok()) << left.error().message;
  EXPECT_TRUE(left->condition().whole());
  EXPECT_NE(not_whole(*left).find("may have gone on: a call was refused: step 1: body 1: found an"), std::string::npos);
  EXPECT_EQ(tumble_log_finish(log), TUMBLE_BAD_INPUT) << "it is whole, and its session is not";
  tumble_log_free(log);
  std::remove(path.c_str());
}

TEST(EngineLogRefusal, OfASecondStateOfABodyInAStep) {
  const auto made = log_of(cube(1));
  ASSERT_TRUE(made.ok()) << made.error().message;
  ASSERT_TRUE((*made)->set_state(1, {}).ok());
  const Status twice = (*made)->set_state(1, {});
  ASSERT_FALSE(twice.ok());
  EXPECT_NE(twice.error().message.find("step 1: found a second state of body 1"), std::string::npos)
      << twice.error().message;
}

// An answer that names the phase would be of both.
TEST(EngineLogRefusal, OfPhasesWithOneName) {
  sim::SceneDef start;
  start.boxes = {cube(1)};
  const auto said_of = [&](const std::vector<std::string>& phases) {
    auto sink = std::make_unique<MemoryByteSink>(std::make_shared<std::vector<std::byte>>(), "toy.tumble");
    const auto log = EngineLog::create(std::move(sink), {{"toy", "1"}, phases}, start);
    return log.ok() ? std::string("taken") : log.error().message;
  };
  EXPECT_EQ(said_of({"solve", "solve 2"}), "taken");
  EXPECT_EQ(said_of({"solve", "move", "solve"}), "engine: phase \"solve\": found twice, wanted names that differ");
  EXPECT_EQ(said_of({"solve", ""}), "engine: phase 2 of 2: found no name, wanted one");
  TumbleLog* log = tumble_log_new("C engine", "0.1");
  TumbleLogStart in_c = {};
  in_c.dt = 0.5, in_c.precision_bits = kBinary32Bits, in_c.phases = "solve,move,solve";
  const std::string path = ::testing::TempDir() + "engine_log_phases.tumble";
  EXPECT_EQ(tumble_log_begin(log, path.c_str(), &in_c), TUMBLE_BAD_INPUT);
  EXPECT_EQ(std::string(tumble_log_message(log)), "engine: phase \"solve\": found twice, wanted names that differ");
  tumble_log_free(log);
}

TEST(EngineLogRefusal, OfAPathWithoutAName) {
  const auto log = EngineLog::create("", {{"toy", "1"}}, sim::SceneDef());
  ASSERT_FALSE(log.ok());
  EXPECT_EQ(log.error().message, "found an empty name, wanted the file of a log");
}

// Pictures, exports and metrics know a body by its id alone.
TEST(EngineLogRefusal, OfAnotherBodyWithTheIdOfARemovedOne) {
  const auto taken_back = [](const sim::BoxDef& box, const std::string& name = "ball") {
    const auto made = log_of(cube(1));
    EngineLog& log = **made;
    EXPECT_TRUE(log.describe_body({1, "ball", {}}).ok());
    EXPECT_TRUE(log.set_state(1, {}).ok());
    EXPECT_TRUE(log.end_step(0.01).ok());
    EXPECT_TRUE(log.input(sim::Remove{1}).ok());
    EXPECT_TRUE(log.end_step(0.01).ok());
    Status told = log.input(sim::Throw{box});
    if (told.ok()) told = log.describe_body({1, name, {}});
    return told.ok() ? std::string("taken") : told.error().message;
  };
  EXPECT_EQ(taken_back(cube(1)), "taken") << "it comes back";
  sim::BoxDef other = cube(1);
  other.position = {4, 5, 6};
  other.velocity = {1, 2, 3};
  EXPECT_EQ(taken_back(other), "taken") << "it comes back elsewhere";
  other.mass = 2;
  EXPECT_NE(taken_back(other).find("step 3: body 1: was removed before and comes back with another mass"),
            std::string::npos)
      << taken_back(other);
  other = cube(1);
  other.size.x() += 0.1;
  EXPECT_NE(taken_back(other).find("another size"), std::string::npos);
  other = cube(1);
  other.is_static = true;
  EXPECT_NE(taken_back(other).find("another kind"), std::string::npos);
  other = cube(1);
  other.material.restitution += 0.1;
  EXPECT_NE(taken_back(other).find("another material"), std::string::npos);
  EXPECT_NE(taken_back(cube(1), "crate").find("step 3: body 1: was removed before and comes back with another name"),
            std::string::npos);
}

TEST(EngineLogRefusal, OfValuesAndContactsOfBodiesThatDoNotExist) {
  sim::SceneDef start;
  start.boxes = {cube(1), cube(2)};
  EngineDef def = {{"toy", "1"}, {}, {}};
  def.declared.channels = {{"joint", {ChannelKind::kFloat64, ChannelScope::kBody}, ""},
                           {"pair", {ChannelKind::kFloat64, ChannelScope::kPair}, ""}};
  const auto end_of = [&](const auto& tell) {
    auto sink = std::make_unique<MemoryByteSink>(std::make_shared<std::vector<std::byte>>(), "toy.tumble");
    const auto log = EngineLog::create(std::move(sink), def, start);
    EXPECT_TRUE((*log)->input(sim::Remove{2}).ok());
    EXPECT_TRUE((*log)->set_state(1, {}).ok());
    EXPECT_TRUE(tell(**log).ok());
    const Status ended = (*log)->end_step(0.01);
    return ended.ok() ? std::string() : ended.error().message;
  };
  const auto contact = [](sim::BodyId a, sim::BodyId b) {
    return [=](EngineLog& log) { return log.add_contact({a, b, {0, 0, 0}, {0, 0, 1}, 0, 0}); };
  };
  EXPECT_EQ(end_of(contact(1, 0)), "");
  EXPECT_EQ(end_of(contact(1, 2)), "") << "a body that this step removed";
  EXPECT_NE(end_of(contact(1, 9)).find("step 1: found a contact of body 9"), std::string::npos);
  EXPECT_EQ(end_of([](EngineLog& log) { return log.set_value(0, 0.5, {1, 0}); }), "");
  EXPECT_NE(end_of([](EngineLog& log) {
              return log.set_value(0, 0.5, {9, 0});
            }).find("channel \"joint\" of body 9"),
            std::string::npos);
  EXPECT_NE(end_of([](EngineLog& log) { return log.set_value(1, 0.5, {9, 1}); }).find("of body 9"), std::string::npos);
  def.declared.start.contacts = {{1, 7, {0, 0, 0}, {0, 0, 1}, 0, 0}};
  auto sink = std::make_unique<MemoryByteSink>(std::make_shared<std::vector<std::byte>>(), "toy.tumble");
  EXPECT_FALSE(EngineLog::create(std::move(sink), def, start).ok());
}

// Whoever reads the log later knows that its session may have had more steps, and why it ends.
TEST(EngineLogRefusal, IsKeptAsTheReasonWhyTheLogEnds) {
  const std::string path = testing::TempDir() + "refused.tumble";
  const auto log_of_path = [&] {
    sim::SceneDef start;
    start.boxes = {cube(1)};
    auto log = EngineLog::create(path, {{"toy", "1"}}, start);
    EXPECT_TRUE(log.ok() && (*log)->set_state(1, {}).ok() && (*log)->end_step(0.01).ok());
    return *std::move(log);
  };
  const auto end_of = [&](const LogSummary& summary) {
    Result<LogReader> log = LogReader::open(path);
    EXPECT_EQ(log->file_bytes(), summary.bytes);
    EXPECT_EQ(log->last_step(), 1U);
    EXPECT_TRUE(verify(*log).condition.whole());
    EXPECT_EQ((*log->read_step(1))->state_hash, summary.final_hash);
    return not_whole(*log);
  };
  const std::string begin = path + ": its session may have gone on: ";
  std::unique_ptr<EngineLog> log = log_of_path();
  ASSERT_FALSE(log->end_step(0.01).ok()) << "a moving body has no state";
  log->drop_step();
  Result<LogSummary> summary = log->finish("the engine was stopped");
  ASSERT_TRUE(summary.ok()) << summary.error().message;
  EXPECT_TRUE(end_of(*summary).starts_with(begin + "a call was refused: step 2: found no state of body 1, wanted"))
      << end_of(*summary);
  log = log_of_path();
  summary = log->finish("the engine was stopped");
  ASSERT_TRUE(summary.ok()) << summary.error().message;
  EXPECT_EQ(end_of(*summary), begin + "the engine was stopped");
  log = log_of_path();
  summary = log->finish();
  ASSERT_TRUE(summary.ok()) << summary.error().message;
  EXPECT_EQ(end_of(*summary), "");
  std::remove(path.c_str());
}

// A reason goes into the log that was written, whatever has its name when the log is finished.
TEST(EngineLogRefusal, TheReasonGoesIntoNoOtherLog) {
  namespace fs = std::filesystem;
  const fs::path before = fs::current_path(), folder = fs::path(testing::TempDir()) / "reasons";
  fs::create_directories(folder / "other");
  const auto begun = [](const std::string& path) {
    sim::SceneDef start;
    start.boxes = {cube(1)};
    auto log = EngineLog::create(path, {{"toy", "1"}}, start);
    EXPECT_TRUE(log.ok() && (*log)->set_state(1, {}).ok() && (*log)->end_step(0.01).ok());
    return *std::move(log);
  };
  const auto end_of = [](const fs::path& path) { return not_whole(*LogReader::open(path.string())); };
  EXPECT_TRUE(begun((folder / "other" / "x.tumble").string())->finish().ok());
  fs::current_path(folder);
  std::unique_ptr<EngineLog> log = begun("x.tumble");
  fs::current_path("other");
  EXPECT_TRUE(log->finish("stopped").ok());
  fs::current_path(before);
  EXPECT_TRUE(end_of(folder / "x.tumble").ends_with("stopped"));
  EXPECT_EQ(end_of(folder / "other" / "x.tumble"), "");

  for (const bool is_gone : {true, false}) {
    const std::string path = (folder / "y.tumble").string();
    log = begun(path);
    fs::rename(path, folder / "moved.tumble");
    if (!is_gone) {
      const std::unique_ptr<EngineLog> another = begun(path);
      EXPECT_TRUE(another->set_state(1, {}).ok() && another->end_step(0.01).ok() && another->finish().ok());
    }
    const Result<LogSummary> summary = log->finish("stopped");
    ASSERT_FALSE(summary.ok()) << "nothing keeps the reason";
    EXPECT_NE(summary.error().message.find("the log is complete, but cannot keep why it ends: "), std::string::npos);
    EXPECT_EQ(end_of(folder / "moved.tumble"), "");
    if (!is_gone) {
      EXPECT_EQ(end_of(path), "");
    }
  }
  fs::remove_all(folder);
}

TEST(EngineLogRefusal, OfCallsAfterTheLastOne) {
  const auto log = log_of(cube(1));
  ASSERT_TRUE(log.ok() && (*log)->finish().ok());
  EXPECT_FALSE((*log)->finish().ok());
  EXPECT_TRUE((*log)->set_state(1, {}).ok());
  EXPECT_FALSE((*log)->end_step(0.01).ok());
}

}  // namespace
}  // namespace tumble::replay
