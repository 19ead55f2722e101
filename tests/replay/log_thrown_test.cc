// Sessions of many bodies that only inputs brought, at rest in rows: their chunks pack to almost nothing, as bombs do,
// and must be read all the same, from damaged logs too.
#include <gtest/gtest.h>

#include <initializer_list>

#include "replay/codec/zstd_frame.h"
#include "replay/format/limits.h"
#include "replay/log/record_writer.h"
#include "replay/log/verify.h"
#include "tests/support/sample_log.h"
#include "tumble/sim/step.h"

namespace tumble::replay {
namespace {

constexpr std::uint64_t kThrown = 60'000;  // a keyframe of them is larger than what may come from few bytes
constexpr std::uint64_t kSteps = 3;        // a quiet one, one with the throws, a quiet one; a chunk each

sim::BoxDef thrown_box(std::uint64_t i) {
  sim::BoxDef box;
  const std::uint64_t row = i / 250;
  box.id = 100 + i;
  box.position = {2 * static_cast<double>(i % 250), 2 * static_cast<double>(row), 0.5};
  box.origin.kind = sim::Origin::Kind::kInput;
  box.frozen = true;
  return box;
}

StepRecord record_of(const sim::World& world, std::uint64_t step) {
  StepRecord record;
  record.step = step;
  record.dt = 1.0 / 64;
  copy_visible(world.bodies(), record.states);
  return record;
}

Status write_chunk(RecordWriter& writer, Keyframe& keyframe, std::span<StepRecord> steps) {
  if (Status ok = writer.begin_chunk(keyframe); !ok.ok()) return ok;
  if (Status ok = writer.add_steps(steps); !ok.ok()) return ok;
  return writer.end_chunk();
}

/// A log of a session in which nothing moves, written without computing its steps, which would take long.
Bytes write_session() {
  sim::SceneDef scene = small_scene(kSteps);
  for (sim::BoxDef& box : scene.boxes) box.spin = {0, 0, 0};
  sim::SceneDef later = scene;
  std::vector<sim::Command> throws;
  for (std::uint64_t i = 0; i < kThrown; ++i) {
    later.boxes.push_back(thrown_box(i));
    throws.emplace_back(sim::Throw{later.boxes.back()});
  }
  const Result<sim::World> before = sim::create_world(scene);
  const Result<sim::World> after = sim::create_world(later);
  EXPECT_TRUE(before.ok() && after.ok());
  const auto disk = std::make_shared<Disk>();
  RecordWriter writer(std::make_unique<MemorySink>(disk));
  EXPECT_TRUE(writer.write_header(header_for(scene), before->state()).ok());
  for (std::uint64_t step = 1; step <= kSteps; ++step) {
    Keyframe keyframe;
    keyframe.state = step > 2 ? after->state() : before->state();
    keyframe.state.step = step - 1;
    std::vector<StepRecord> steps = {record_of(step > 1 ? *after : *before, step)};
    if (step == 2) steps[0].inputs = throws;
    const Status written = write_chunk(writer, keyframe, steps);
    EXPECT_TRUE(written.ok()) << written.error().message;
  }
  EXPECT_TRUE(writer.finish().ok());
  return disk->bytes;
}

struct Session {
  Bytes bytes;
  std::vector<std::uint64_t> records;  ///< offsets: header, 3 chunks, index
};

const Session& session() {
  static const Session made = [] {
    Session s = {write_session(), {}};
    for (std::uint64_t at = 0; at + kFooterBytes < s.bytes.size();) {
      s.records.push_back(at);
      at += kPreludeBytes +
            decode_prelude(std::span<const std::byte>(s.bytes).subspan(at).first<kPreludeBytes>())->stored_bytes;
    }
    return s;
  }();
  return made;
}

Prelude prelude_of(const Bytes& bytes, std::uint64_t at) {
  return *decode_prelude(std::span<const std::byte>(bytes).subspan(at).first<kPreludeBytes>());
}

/// Bytes with the middle of a record's payload changed.
Bytes without(std::initializer_list<std::size_t> records) {
  Bytes bytes = session().bytes;
  for (const std::size_t record : records) {
    const std::uint64_t at = session().records[record];
    bytes[at + kPreludeBytes + prelude_of(bytes, at).stored_bytes / 2] ^= std::byte{255};
  }
  return bytes;
}

void expect_bodies(const Bytes& bytes, std::uint64_t step, std::uint64_t bodies) {
  Result<LogReader> log = open_memory(bytes);
  ASSERT_TRUE(log.ok()) << log.error().message;
  const Result<const StepRecord*> record = log->read_step(step);
  ASSERT_TRUE(record.ok()) << record.error().message;
  EXPECT_EQ((*record)->states.size(), bodies);
}

TEST(ThrownBodies, PackBetterThanFewBytesMay) {
  const Prelude last = prelude_of(session().bytes, session().records[3]);
  EXPECT_GT(last.raw_bytes, kEasyBytes);
  EXPECT_GT(last.raw_bytes, last.stored_bytes * kLargeExpansionMax);
}

TEST(ThrownBodies, AreReadAndVerified) {
  expect_bodies(session().bytes, 1, 3);
  expect_bodies(session().bytes, 3, 3 + kThrown);
  Result<LogReader> log = open_memory(session().bytes);
  ASSERT_TRUE(log.ok());
  EXPECT_EQ(verify(*log).condition.summary(log->last_step()), "whole");
}

TEST(ThrownBodies, AreRecoveredWithoutTheHeader) {
  const Result<RecoveredLog> recovered = recover_memory(without({0}));
  ASSERT_TRUE(recovered.ok()) << recovered.error().message;
  EXPECT_EQ(recovered->report.steps, kSteps);
  EXPECT_TRUE(recovered->report.header_lost);
  expect_bodies(recovered->bytes, 3, 3 + kThrown);
}

TEST(ThrownBodies, AreRecoveredWithoutTheInputsThatThrewThem) {
  const Result<RecoveredLog> recovered = recover_memory(without({2}));
  ASSERT_TRUE(recovered.ok()) << recovered.error().message;
  EXPECT_EQ(recovered->report.lost, std::vector<MissingSteps>({{2, 1}}));
  EXPECT_LT(recovered->bytes.size(), std::size_t{1} << 17);  // too few for a chunk that packs as it did
  expect_bodies(recovered->bytes, 3, 3 + kThrown);
}

TEST(ThrownBodies, AreRecoveredFromTheLastChunkAlone) {
  const Result<RecoveredLog> recovered = recover_memory(without({0, 1, 2}));
  ASSERT_TRUE(recovered.ok()) << recovered.error().message;
  expect_bodies(recovered->bytes, 3, 3 + kThrown);
}

TEST(ThrownBodies, AreWrittenSoThatTheyCanBeReadWhateverToldOfThem) {
  sim::SceneDef many = small_scene(1);
  many.boxes.clear();
  for (std::uint64_t i = 0; i < kThrown; ++i) many.boxes.push_back(thrown_box(i));
  const Result<sim::World> world = sim::create_world(many);
  ASSERT_TRUE(world.ok());
  const auto disk = std::make_shared<Disk>();
  RecordWriter writer(std::make_unique<MemorySink>(disk));
  ASSERT_TRUE(writer.write_header(header_for(small_scene(1)), world->state()).ok());
  Keyframe keyframe = {world->state(), {}};
  std::vector<StepRecord> steps = {record_of(*world, 1)};
  ASSERT_TRUE(write_chunk(writer, keyframe, steps).ok());
  ASSERT_TRUE(writer.finish().ok());
  expect_bodies(disk->bytes, 1, kThrown);
}

TEST(ThrownBodies, AHeaderThatWouldBeTakenForABombIsNotWritten) {
  LogHeader header = header_for(small_scene(1));
  header.scene_text.assign(2 * kHeaderEasyBytes, '#');
  RecordWriter writer(std::make_unique<MemorySink>(std::make_shared<Disk>()));
  const Status written = writer.write_header(header, sim::create_world(header.scene)->state());
  ASSERT_FALSE(written.ok());
  EXPECT_NE(written.error().message.find("so few that no program would read it again"), std::string::npos)
      << written.error().message;
}

TEST(ThrownBodies, NothingPacksSoWellInANarrowWindowThatReadersRefuseIt) {
  Compressor narrow(1, kNarrowWindowLog);
  Bytes stored;
  for (const std::size_t size : {2 * kEasyBytes, 3 * kEasyBytes + 8}) {
    ASSERT_TRUE(narrow.compress(Bytes(size), stored).ok());
    EXPECT_TRUE(decompress(stored, size, message_bytes_max(stored.size())).ok()) << size << " in " << stored.size();
  }
}

}  // namespace
}  // namespace tumble::replay
