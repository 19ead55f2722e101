// Every way in which a log's bytes may be wrong: cut anywhere, changed anywhere, not a log at all.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdio>
#include <fstream>

#include "replay/codec/header_codec.h"
#include "replay/codec/zstd_frame.h"
#include "replay/format/little_endian.h"
#include "replay/log/verify.h"
#include "tests/support/sample_log.h"

namespace tumble::replay {
namespace {

/// Every chunk that the reader offers must be what was recorded, but for the record at `hurt`.
void expect_rest_is_readable(LogReader& log, std::uint64_t hurt) {
  for (const ChunkPlace& place : log.chunks()) {
    if (place.offset == hurt) continue;
    for (std::uint64_t k = place.first_step; k < place.end_step(); ++k) {
      const Result<const StepRecord*> step = log.read_step(k);
      ASSERT_TRUE(step.ok()) << step.error().message;
      ASSERT_TRUE(same_bits((*step)->states, sample_log().states[k])) << k;
    }
  }
}

TEST(LogReader, TornTailIsReportedAtEveryLength) {
  const SampleLog& s = sample_log();
  ASSERT_EQ(s.records.size(), 7U);
  for (std::uint64_t length = 0; length < s.bytes.size(); ++length) {
    SCOPED_TRACE("cut to " + std::to_string(length));
    const auto end = s.bytes.begin() + static_cast<std::ptrdiff_t>(length);
    Result<LogReader> log = open_memory(Bytes(s.bytes.begin(), end));
    if (length < s.records[1]) {
      ASSERT_FALSE(log.ok());
      EXPECT_EQ(log.error().kind, ErrorKind::kDamaged) << log.error().message;
      continue;
    }
    ASSERT_TRUE(log.ok()) << log.error().message;
    const auto last_end = std::prev(std::upper_bound(s.records.begin(), s.records.end(), length));
    EXPECT_TRUE(log->condition().torn);
    EXPECT_FALSE(log->condition().finished);
    EXPECT_TRUE(log->condition().damages.empty());
    EXPECT_EQ(log->condition().torn_offset, *last_end);
    const auto complete = std::min<std::size_t>(static_cast<std::size_t>(last_end - s.records.begin()) - 1, 4);
    ASSERT_EQ(log->chunks().size(), complete);
    EXPECT_EQ(log->step_count(), complete * 6);
    expect_rest_is_readable(*log, 0);
    const VerifyReport report = verify(*log);
    EXPECT_TRUE(report.condition.torn);
    EXPECT_TRUE(report.condition.damages.empty());
    EXPECT_EQ(report.steps_checked, complete * 6);
  }
}

TEST(LogReader, AFlippedBitAnywhereIsFoundInItsRecord) {
  const SampleLog& s = sample_log();
  for (std::uint64_t byte = 0; byte < s.bytes.size(); ++byte) {
    SCOPED_TRACE("byte " + std::to_string(byte));
    Bytes bytes = s.bytes;
    bytes[byte] ^= static_cast<std::byte>(1U << (byte % 8));
    Result<LogReader> log = open_memory(bytes);
    const std::uint64_t hurt = s.record_of(byte);
    if (hurt == 0) {  // the header
      ASSERT_FALSE(log.ok());
      EXPECT_EQ(log.error().kind, ErrorKind::kDamaged) << log.error().message;
      EXPECT_NE(log.error().message.find("memory.tumble: header at byte 0"), std::string::npos) << log.error().message;
      continue;
    }
    ASSERT_TRUE(log.ok()) << log.error().message;
    expect_rest_is_readable(*log, hurt);
    const VerifyReport report = verify(*log);
    ASSERT_EQ(report.condition.damages.size(), 1U) << report.condition.damages.back().message;
    const Damage& damage = report.condition.damages.front();
    EXPECT_EQ(damage.offset, hurt) << damage.message;
    EXPECT_NE(damage.message.find("at byte " + std::to_string(hurt)), std::string::npos) << damage.message;
    const RecordKind wanted = hurt == s.records[6]   ? RecordKind::kFooter
                              : hurt == s.records[5] ? RecordKind::kIndex
                                                     : RecordKind::kChunk;
    EXPECT_EQ(damage.kind, wanted) << damage.message;
    EXPECT_FALSE(report.condition.torn);
  }
}

TEST(LogReader, ReadingADamagedStepNamesRecordFoundAndWanted) {
  Bytes bytes = sample_log().bytes;
  bytes[sample_log().records[2] + kPreludeBytes + 20] ^= std::byte{1};
  Result<LogReader> log = open_memory(bytes);
  ASSERT_TRUE(log.ok());
  const Result<const StepRecord*> step = log->read_step(8);
  ASSERT_FALSE(step.ok());
  EXPECT_EQ(step.error().kind, ErrorKind::kDamaged);
  const std::string place = "chunk at byte " + std::to_string(sample_log().records[2]);
  for (const std::string& part :
       {std::string("memory.tumble"), place, std::string("found hash"), std::string("wanted")}) {
    EXPECT_NE(step.error().message.find(part), std::string::npos) << step.error().message;
  }
}

TEST(LogReader, ALostRecordLeavesAGapThatIsNamed) {
  Bytes bytes = sample_log().bytes;
  bytes[sample_log().records[2] + 30] ^= std::byte{1};  // a prelude: the record cannot be found any more
  bytes.resize(bytes.size() - 1);                       // and no footer
  Result<LogReader> log = open_memory(bytes);
  ASSERT_TRUE(log.ok());
  EXPECT_EQ(log->step_count(), 24U);
  EXPECT_TRUE(log->read_step(6).ok());
  EXPECT_TRUE(log->read_step(13).ok());
  const Result<const StepRecord*> lost = log->read_step(9);
  ASSERT_FALSE(lost.ok());
  EXPECT_EQ(lost.error().kind, ErrorKind::kDamaged);
}

TEST(LogReader, ChunksTakenOutSwappedOrFromAnotherLogShow) {
  const SampleLog& s = sample_log();
  for (const std::vector<std::size_t>& order : {std::vector<std::size_t>{0, 1, 3, 4}, {0, 2, 1, 3, 4}, {0, 1, 1, 2}}) {
    Result<LogReader> log = open_memory(s.joined(order));
    ASSERT_TRUE(log.ok());
    EXPECT_FALSE(verify(*log).condition.damages.empty());
  }
  sim::SceneDef other = scene_with_inputs(24);
  other.title = "another header";
  const Bytes foreign = record_to_memory(other, {}, 6);
  Result<LogReader> source = open_memory(foreign);
  Bytes mixed = s.joined({0, 1});
  const ChunkPlace& place = source->chunks()[1];
  mixed.insert(mixed.end(), foreign.begin() + static_cast<std::ptrdiff_t>(place.offset),
               foreign.begin() + static_cast<std::ptrdiff_t>(place.offset + place.length));
  Result<LogReader> log = open_memory(mixed);
  ASSERT_TRUE(log.ok());
  EXPECT_FALSE(log->condition().damages.empty());
  EXPECT_EQ(log->step_count(), 6U);
}

TEST(LogReader, BytesAfterTheFooterAreReported) {
  Bytes bytes = sample_log().bytes;
  bytes.insert(bytes.end(), 5, std::byte{7});
  Result<LogReader> log = open_memory(bytes);
  ASSERT_TRUE(log.ok());
  const VerifyReport report = verify(*log);
  ASSERT_EQ(report.condition.damages.size(), 1U);
  EXPECT_EQ(report.condition.damages[0].offset, sample_log().bytes.size());
  EXPECT_NE(report.condition.damages[0].message.find("5 bytes after the footer"), std::string::npos);
}

TEST(LogReader, ATailOfZerosIsATornTail) {
  Bytes bytes(sample_log().bytes.begin(),
              sample_log().bytes.begin() + static_cast<std::ptrdiff_t>(sample_log().records[3]));
  bytes.resize(bytes.size() + 10000);
  Result<LogReader> log = open_memory(bytes);
  ASSERT_TRUE(log.ok());
  EXPECT_TRUE(log->condition().torn);
  EXPECT_TRUE(log->condition().damages.empty());
  EXPECT_EQ(log->step_count(), 12U);
}

TEST(LogReader, AFutureVersionIsNamed) {
  Bytes bytes = sample_log().bytes;
  Result<Prelude> prelude = decode_prelude(std::span<const std::byte>(bytes).first<kPreludeBytes>());
  ASSERT_TRUE(prelude.ok());
  prelude->major = 3;
  const auto encoded = encode(*prelude);
  std::copy(encoded.begin(), encoded.end(), bytes.begin());
  const Result<LogReader> log = open_memory(bytes);
  ASSERT_FALSE(log.ok());
  EXPECT_EQ(log.error().kind, ErrorKind::kBadInput);
  EXPECT_NE(log.error().message.find("format version 3."), std::string::npos) << log.error().message;
  EXPECT_NE(log.error().message.find("memory.tumble"), std::string::npos);
}

TEST(LogReader, AnInputOfAnUnknownKindIsNamed) {
  sim::SceneDef scene = small_scene();
  constexpr std::uint64_t kStep = 0x0000123456789abc;
  scene.inputs = {{kStep, sim::Wake{10}}};
  Result<MessageBytes> message = encode_header(header_for(scene));
  ASSERT_TRUE(message.ok());
  const std::span<std::byte> bytes = message->bytes();
  bool found = false;
  for (std::size_t at = 0; at + 16 <= bytes.size(); at += 8) {
    if (load<std::uint64_t>(bytes.data() + at) != kStep) continue;
    store(bytes.data() + at + 8, std::uint16_t{999});  // the union's tag follows the step
    found = true;
  }
  ASSERT_TRUE(found);
  const Result<LogHeader> header = decode_header(*message);
  ASSERT_FALSE(header.ok());
  EXPECT_EQ(header.error().kind, ErrorKind::kBadInput);
  EXPECT_NE(header.error().message.find("\"wake\""), std::string::npos) << header.error().message;
}

TEST(LogReader, OtherFilesAreNotLogs) {
  const std::string folder = testing::TempDir();
  const std::string path = folder + "/not_a_log.tumble";
  std::ofstream(path) << "name = \"a scene, and longer than a prelude\"\n" << std::string(300, '#');
  Result<LogReader> log = LogReader::open(path);
  ASSERT_FALSE(log.ok());
  EXPECT_EQ(log.error().kind, ErrorKind::kBadInput);
  EXPECT_NE(log.error().message.find(path), std::string::npos);
  std::ofstream(path, std::ios::trunc).flush();
  log = LogReader::open(path);
  ASSERT_FALSE(log.ok());
  EXPECT_NE(log.error().message.find("empty"), std::string::npos) << log.error().message;
  std::remove(path.c_str());
  log = LogReader::open(path);
  ASSERT_FALSE(log.ok());
  EXPECT_EQ(log.error().kind, ErrorKind::kBadInput);
  EXPECT_NE(log.error().message.find("No such file"), std::string::npos) << log.error().message;
  log = LogReader::open(folder);
  ASSERT_FALSE(log.ok());
  EXPECT_EQ(log.error().kind, ErrorKind::kBadInput);
  EXPECT_NE(log.error().message.find("folder"), std::string::npos) << log.error().message;
}

TEST(Decompress, ClaimsThatCannotBeAreRefusedBeforeMemoryIsTaken) {
  Compressor compressor;
  Bytes frame;
  const Bytes raw(4096);
  ASSERT_TRUE(compressor.compress(raw, frame).ok());
  EXPECT_TRUE(decompress(frame, 4096, 1 << 20).ok());
  EXPECT_FALSE(decompress(frame, 4088, 1 << 20).ok());
  EXPECT_FALSE(decompress(frame, 4096, 4000).ok());
  EXPECT_FALSE(decompress(frame, std::uint64_t{1} << 40, ~std::uint64_t{0}).ok());
  frame.insert(frame.end(), frame.begin(), frame.end());
  EXPECT_FALSE(decompress(frame, 4096, 1 << 20).ok());
}

}  // namespace
}  // namespace tumble::replay
