// Channels, contacts, names, shapes, notes, snapshots and views: what an engine gives is what a log returns, to the
// bit; values and contacts are in the chain, the rest is not.
#include "tumble/replay/extras.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "replay/log/byte_memory.h"
#include "replay/log/record_reader.h"
#include "replay/log/verify.h"
#include "replay/recover/recover.h"
#include "replay/view/timeline.h"
#include "tests/support/log_memory.h"
#include "tumble/replay/engine_log.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/prelude.h"

namespace tumble::replay {
namespace {

constexpr std::uint64_t kSteps = 150;  // three chunks

Declared declared() {
  Declared declared;
  declared.channels = {{"angle", {ChannelKind::kFloat64, ChannelScope::kBody}, "rad"},
                       {"blob", {ChannelKind::kBytes, ChannelScope::kWorld}, ""},
                       {"force", {ChannelKind::kFloat32, ChannelScope::kPair}, "N"},
                       {"mode", {ChannelKind::kText, ChannelScope::kBody}, ""},
                       {"offset", {ChannelKind::kInt64, ChannelScope::kWorld}, ""},
                       {"seed", {ChannelKind::kUint64, ChannelScope::kWorld}, ""}};
  Shape ball;
  ball.radius = 0.5;
  declared.shapes = {ball};
  declared.bodies = {{1, "ball", hash_of(ball)}, {2, "box", {}}};
  declared.start.channels.resize(6);
  declared.start.channels[5].add({}, std::uint64_t{42});
  return declared;
}

Shape tetrahedron() {
  Shape hull;
  hull.kind = Shape::Kind::kHull;
  hull.points = {{0, 0, 0.5}, {0.5, 0, -0.5}, {-0.5, 0.5, -0.5}, {-0.5, -0.5, -0.5}};
  return hull;
}

/// What a session differs in from another.
struct Change {
  double angle = 0;
  double impulse = 0;
  std::string note = "begun";
  std::uint64_t seed = 42;
};

sim::BoxDef cube(sim::BodyId id) {
  sim::BoxDef box;
  box.id = id;
  box.position = {2.0 * static_cast<double>(id), 0, 0.5};
  return box;
}

void give_values(EngineLog& log, std::uint64_t k, const Change& change) {
  const auto t = static_cast<double>(k);
  const auto set = [&](std::size_t channel, const ChannelValue& value, const ChannelKey& key = {}) {
    const Status ok = log.set_value(channel, value, key);
    EXPECT_TRUE(ok.ok()) << ok.error().message;
  };
  set(0, k == 90 ? std::sin(t) + change.angle : std::sin(t), {2, 0});
  set(0, k == 7 ? std::numeric_limits<double>::quiet_NaN() : -0.0, {1, 0});
  if (k % 3 == 0) set(1, std::string("\0\x01\xff", 3));
  if (k != 5) set(2, static_cast<float>(t) / 3, {1, 2});
  if (k > 20) set(2, -static_cast<float>(t), {2, 1});
  set(3, std::string(k % 2 == 0 ? "walks" : "jumps"), {1, 0});
  set(4, static_cast<std::int64_t>(k) - 75);
  set(5, std::numeric_limits<std::uint64_t>::max() - k);
}

MemoryFile session(const Change& change = {}) {
  auto file = std::make_shared<std::vector<std::byte>>();
  sim::SceneDef start;
  start.name = "extras";
  start.boxes = {cube(1), cube(2)};
  EngineDef def = {{"toy", "1"}};
  def.declared = declared();
  def.declared.start.channels[5].bits = {change.seed};
  auto log = EngineLog::create(std::make_unique<MemoryByteSink>(file, "extras.tumble"), def, start);
  EXPECT_TRUE(log.ok()) << log.error().message;
  for (std::uint64_t k = 1; k <= kSteps; ++k) {
    if (k == 100) {
      const Shape hull = tetrahedron();
      EXPECT_TRUE((*log)->input(sim::Throw{cube(9)}).ok());
      EXPECT_TRUE((*log)->describe_body({9, "rock", hash_of(hull)}, &hull).ok());
    }
    give_values(**log, k, change);
    for (const sim::BoxDef& box : {cube(1), cube(2), cube(9)}) {
      if (box.id == 9 && k < 100) continue;
      EXPECT_TRUE((*log)->set_state(box.id, {box.position, {}, {0, 0, 0}, {0, 0, 0}, false}).ok());
    }
    EXPECT_TRUE((*log)->add_contact({2, 0, {4, 0, 0}, {0, 0, -1}, 0.01, 0.5 + change.impulse}).ok());
    EXPECT_TRUE((*log)->add_contact({1, 2, {3, 0, 0}, {1, 0, 0}, -0.01, 0}).ok());
    if (k == 3) {
      EXPECT_TRUE((*log)->add_note(change.note).ok());
    }
    if (k == 4) {
      EXPECT_TRUE((*log)->add_snapshot(std::as_bytes(std::span("state", 5)), "whole").ok());
    }
    if (k == 6) {
      EXPECT_TRUE((*log)->add_superseded({true, "position.x of body 1"}).ok());
    }
    const Status ended = (*log)->end_step(0.01);
    EXPECT_TRUE(ended.ok()) << ended.error().message;
  }
  EXPECT_TRUE((*log)->finish().ok());
  return file;
}

LogReader read(const MemoryFile& file) {
  Result<LogReader> log = LogReader::open(std::make_unique<MemoryByteSource>(file, "extras.tumble"));
  EXPECT_TRUE(log.ok()) << log.error().message;
  return *std::move(log);
}

Hash128 last_chain(const MemoryFile& file) { return *read(file).chain_at(kSteps); }

TEST(Extras, ComeBackToTheBit) {
  const MemoryFile file = session();
  LogReader log = read(file);
  EXPECT_EQ(log.header().format_major, kExtrasMajor);
  EXPECT_EQ(log.header().declared.channels, declared().channels);
  const LogCondition condition = verify(log).condition;
  EXPECT_TRUE(condition.sound()) << (condition.damages.empty() ? "" : condition.damages.front().message);
  for (const std::uint64_t k : {150U, 7U, 5U, 30U}) {
    const StepRecord& step = **log.read_step(k);
    const ChannelValues& angle = step.extras.values(0);
    ASSERT_EQ(angle.size(), 2U);
    EXPECT_EQ(std::get<double>(angle.value(1, ChannelKind::kFloat64)), std::sin(static_cast<double>(k)));
    EXPECT_EQ(std::isnan(std::get<double>(angle.value(0, ChannelKind::kFloat64))), k == 7);
    EXPECT_EQ(step.extras.values(1).size(), k % 3 == 0 ? 1U : 0U);
    EXPECT_EQ(step.extras.values(2).size(), (k == 5 ? 0U : 1U) + (k > 20 ? 1U : 0U));
    EXPECT_EQ(step.extras.values(3).bytes.front(), k % 2 == 0 ? "walks" : "jumps");
    EXPECT_EQ(std::get<std::int64_t>(step.extras.values(4).value(0, ChannelKind::kInt64)),
              static_cast<std::int64_t>(k) - 75);
    ASSERT_EQ(step.extras.contacts.size(), 2U);
    EXPECT_EQ(step.extras.contacts[1].impulse, 0.5);  // ordered by pair
  }
  EXPECT_EQ((*log.read_step(3))->extras.values(1).bytes.front(), std::string("\0\x01\xff", 3));
  EXPECT_EQ((*log.read_step(3))->extras.notes.front(), "begun");
  EXPECT_EQ((*log.read_step(4))->extras.snapshots.front(), (EngineSnapshot{"whole", "state"}));
  EXPECT_EQ((*log.read_step(6))->extras.superseded.front().difference, "position.x of body 1");
  EXPECT_EQ((*log.read_step(0))->extras.values(5).bits.front(), 42U);
}

TEST(Extras, TheTimelineCountsTheContactsThatWereTold) {
  const MemoryFile file = session();
  LogReader log = read(file);
  TimelineScan timeline(log);
  EXPECT_EQ(timeline.next().contacts, 0U);  // none were told of the start
  EXPECT_EQ(timeline.next().contacts, 2U);
}

TEST(Extras, NamesAndShapesAreFoundWhereverTheyWereGiven) {
  const MemoryFile file = session();
  LogReader log = read(file);
  EXPECT_EQ(log.bodies().text(1), "body 1 (ball)");
  EXPECT_EQ(log.bodies().name(9), "rock");
  ASSERT_NE(log.bodies().shape(9), nullptr);
  EXPECT_EQ(*log.bodies().shape(9), tetrahedron());
  EXPECT_EQ(log.bodies().shape(2), nullptr);
  EXPECT_EQ(log.bodies().shape_count(), 2U);
}

TEST(Extras, ValuesAndContactsAreInTheChainAndTextsAreNot) {
  const Hash128 chain = last_chain(session());
  EXPECT_EQ(last_chain(session()), chain);
  EXPECT_NE(last_chain(session({.angle = 1e-16 + 1e-15})), chain);
  EXPECT_NE(last_chain(session({.impulse = 1e-9})), chain);
  EXPECT_NE(last_chain(session({.seed = 43})), chain);
  EXPECT_EQ(last_chain(session({.note = "other"})), chain);
}

TEST(Extras, RecoverKeepsThemAndTheirChannels) {
  const MemoryFile file = session();
  const Hash128 chain = last_chain(file);
  LogReader whole = read(file);
  const ChunkPlace first = whole.chunks().front();
  for (const bool header : {false, true}) {
    auto hurt = std::make_shared<std::vector<std::byte>>(*file);
    const std::size_t at = header ? 200 : first.offset + kPreludeBytes + 40;
    (*hurt)[at] ^= std::byte{1};
    auto mended = std::make_shared<std::vector<std::byte>>();
    const MemoryByteSource source(hurt, "hurt.tumble");
    const auto report = recover_log(source, std::make_unique<MemoryByteSink>(mended, "mended.tumble"));
    ASSERT_TRUE(report.ok()) << report.error().message;
    LogReader log = read(mended);
    EXPECT_TRUE(verify(log).condition.damages.empty());
    EXPECT_EQ(*log.chain_at(kSteps), chain);
    const StepRecord& step = **log.read_step(kSteps);
    EXPECT_EQ(step.extras.values(4).bits.front(), 75U);
    EXPECT_EQ(log.header().declared.channels.size(), 6U);
    EXPECT_EQ(log.header().declared.channels[4].name, header ? "channel 0004" : "offset");
    EXPECT_TRUE(log.header().declared.start.empty() || !header);
  }
}

/// Changes the message of a chunk as an attacker who keeps every hash right could, and decodes all of it.
TEST(Extras, HostileMessagesAreRefusedAndNothingWorse) {
  const MemoryFile file = session();
  LogReader log = read(file);
  const MemoryByteSource source(file, "extras.tumble");
  const RecordReader records(source);
  std::mt19937_64 random(19);
  std::size_t refused = 0;
  for (const std::uint64_t offset : {log.chunks()[0].offset, log.chunks()[1].offset}) {
    const Result<Prelude> prelude = records.read_prelude(offset);
    ASSERT_TRUE(prelude.ok());
    for (int k = 0; k < 3000; ++k) {
      Result<MessageBytes> message = records.read_payload(offset, *prelude);
      ASSERT_TRUE(message.ok());
      const std::span<std::byte> bytes = message->bytes();
      for (int n = 0; n <= k % 3; ++n) {
        const std::size_t at = random() % bytes.size();
        bytes[at] = k % 2 == 0 ? static_cast<std::byte>(random()) : bytes[at] ^ std::byte{1};
      }
      Result<ChunkDecoder> chunk = ChunkDecoder::open(*message);
      refused += chunk.ok() ? 0U : 1U;
      for (std::size_t i = 0; chunk.ok() && i < chunk->step_count() && chunk->step(i).ok(); ++i) {
      }
    }
  }
  EXPECT_GT(refused, 100U);
}

TEST(Extras, AWrongValueIsAnErrorThatNamesTheChannel) {
  auto file = std::make_shared<std::vector<std::byte>>();
  sim::SceneDef start;
  start.name = "wrong";
  start.boxes = {cube(1), cube(2)};
  EngineDef def = {{"toy", "1"}};
  def.declared = declared();
  auto log = EngineLog::create(std::make_unique<MemoryByteSink>(file, "wrong.tumble"), def, start);
  ASSERT_TRUE(log.ok());
  const auto refused = [&](std::size_t channel, const ChannelValue& value, const ChannelKey& key, const char* part) {
    const Status status = (*log)->set_value(channel, value, key);
    ASSERT_FALSE(status.ok()) << part;
    EXPECT_NE(status.error().message.find(part), std::string::npos) << status.error().message;
  };
  refused(6, 1.0, {}, "channel 6");
  refused(0, 1.0F, {1, 0}, "found a float32, wanted a float64");
  refused(0, 1.0, {}, "scope body");
  refused(2, 1.0F, {1, 0}, "scope pair");
  EXPECT_TRUE((*log)->set_value(0, 1.0, {1, 0}).ok());
  refused(0, 1.0, {1, 0}, "a second value in one step");
  EXPECT_FALSE((*log)->describe_body({5, "x", hash_of(tetrahedron())}).ok());
  EXPECT_FALSE((*log)->add_contact({0, 1, {}, {}, 0, 0}).ok());
  def.declared.channels[1].name = "angle";
  EXPECT_FALSE(EngineLog::create(std::make_unique<MemoryByteSink>(file, "wrong.tumble"), def, start).ok());
  def.declared.channels[1].name = "a=b";
  EXPECT_FALSE(EngineLog::create(std::make_unique<MemoryByteSink>(file, "wrong.tumble"), def, start).ok());
}

}  // namespace
}  // namespace tumble::replay
