// Files made to mislead: messages and preludes with wrong contents and right hashes. Whatever is in them, reading ends,
// with an answer or an error, and takes no more memory than limits.h allows. Sanitizers make this test sharp.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "replay/codec/chunk_codec.h"
#include "replay/codec/index_codec.h"
#include "replay/codec/zstd_frame.h"
#include "replay/format/limits.h"
#include "replay/log/verify.h"
#include "tests/support/log_memory.h"

namespace tumble::replay {
namespace {

struct Record {
  Prelude prelude;
  Bytes message;
};

/// A small log taken apart: header, chunks, index; the footer is left off.
std::vector<Record> records_of(const Bytes& bytes) {
  std::vector<Record> records;
  std::size_t at = 0;
  while (at + kFooterBytes < bytes.size()) {
    const std::span<const std::byte> rest = std::span(bytes).subspan(at);
    const Result<Prelude> prelude = decode_prelude(rest.first<kPreludeBytes>());
    EXPECT_TRUE(prelude.ok());
    const auto stored = rest.subspan(kPreludeBytes, prelude->stored_bytes);
    const Result<MessageBytes> message = decompress(stored, prelude->raw_bytes, 1 << 30);
    EXPECT_TRUE(message.ok());
    records.push_back({*prelude, Bytes(message->bytes().begin(), message->bytes().end())});
    at += kPreludeBytes + prelude->stored_bytes;
  }
  return records;
}

/// Puts records together again, with hashes that fit what is in them.
Bytes joined(std::vector<Record> records) {
  Bytes bytes;
  Compressor compressor;
  Bytes stored;
  std::uint64_t tag = 0;
  for (Record& record : records) {
    EXPECT_TRUE(compressor.compress(record.message, stored).ok());
    record.prelude.stored_bytes = stored.size();
    record.prelude.stored_hash = hash_bytes(stored);
    if (record.prelude.kind == RecordKind::kHeader) tag = record.prelude.stored_hash.low;
    record.prelude.log_tag = tag;
    const auto prelude = encode(record.prelude);
    bytes.insert(bytes.end(), prelude.begin(), prelude.end());
    bytes.insert(bytes.end(), stored.begin(), stored.end());
  }
  return bytes;
}

const std::vector<Record>& sample(sim::Method method) {
  static const std::vector<Record> thesis = records_of(record_to_memory(scene_with_inputs(12), {}, 4));
  static const std::vector<Record> layered =
      records_of(record_to_memory(scene_with_inputs(12, sim::Method::kLayered), {}, 4));
  return method == sim::Method::kThesis ? thesis : layered;
}

/// Everything a program may do with a log, to see it come back.
void read_everything(const Bytes& bytes) {
  Result<LogReader> log = open_memory(bytes);
  if (!log.ok()) {
    EXPECT_FALSE(log.error().message.empty());
    return;
  }
  for (std::uint64_t k = 0; k <= std::min<std::uint64_t>(log->step_count(), 40); ++k) {
    (void)log->read_step(k).ok();
    (void)log->keyframe_at_or_before(k).ok();
  }
  (void)verify(*log).condition.summary(log->step_count());
}

TEST(HostileLog, TheUnchangedSampleIsReadable) {
  Result<LogReader> log = open_memory(joined(sample(sim::Method::kThesis)));
  ASSERT_TRUE(log.ok());
  EXPECT_EQ(log->step_count(), 12U);
  EXPECT_TRUE(verify(*log).condition.damages.empty());
}

TEST(HostileLog, MessagesWithChangedBytesDoNoHarm) {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 1500; ++trial) {
    std::vector<Record> records = sample(kMethods[static_cast<std::size_t>(trial) % 2]);
    Record& record = records[random() % records.size()];
    for (std::uint64_t changes = 1 + random() % 4; changes > 0; --changes) {
      std::byte& byte = record.message[random() % record.message.size()];
      byte = random() % 2 == 0 ? static_cast<std::byte>(random()) : byte ^ static_cast<std::byte>(1U << random() % 8);
    }
    read_everything(joined(std::move(records)));
  }
}

TEST(HostileLog, AFewBytesThatWouldFillTheMemoryAreRefused) {
  for (const std::size_t record : {0U, 1U, 3U}) {  // header, chunk, index
    std::vector<Record> records = sample(sim::Method::kThesis);
    const std::uint64_t most = record == 0 ? header_bytes_max(0) : message_bytes_max(0);
    records[record].message.assign(most + 8, std::byte{0});
    records[record].prelude.raw_bytes = records[record].message.size();
    Result<LogReader> log = open_memory(joined(std::move(records)));
    ASSERT_EQ(log.ok(), record != 0);
    const std::string said =
        log.ok() ? verify(*log).condition.damages.front().message : std::string(log.error().message);
    EXPECT_NE(said.find("that can come from so few"), std::string::npos) << said;
  }
}

TEST(HostileLog, MessagesCutShortDoNoHarm) {
  std::mt19937_64 random(8);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Record> records = sample(sim::Method::kLayered);
    Record& record = records[random() % records.size()];
    record.message.resize(random() % (record.message.size() / 8) * 8);
    record.prelude.raw_bytes = record.message.size();
    read_everything(joined(std::move(records)));
  }
}

TEST(HostileLog, PreludesWithAnyNumbersDoNoHarm) {
  std::mt19937_64 random(9);
  for (int trial = 0; trial < 1500; ++trial) {
    Bytes bytes = joined(sample(sim::Method::kThesis));
    std::vector<std::size_t> offsets;
    for (std::size_t at = 0; at < bytes.size();) {
      offsets.push_back(at);
      at += kPreludeBytes +
            decode_prelude(std::span<const std::byte>(bytes).subspan(at).first<kPreludeBytes>())->stored_bytes;
    }
    const auto place = std::span(bytes).subspan(offsets[random() % offsets.size()]).first<kPreludeBytes>();
    Prelude prelude = *decode_prelude(place);
    const std::uint64_t number = random() >> (random() % 64);
    switch (random() % 7) {
      case 0:
        prelude.first_step = number;
        break;
      case 1:
        prelude.step_count = number;
        break;
      case 2:
        prelude.stored_bytes = number;
        break;
      case 3:
        prelude.raw_bytes = number;
        break;
      case 4:
        prelude.sequence = number;
        break;
      case 5:
        prelude.log_tag = number;
        break;
      default:
        prelude.kind = static_cast<RecordKind>(number % 6);
        break;
    }
    const auto encoded = encode(prelude);
    std::copy(encoded.begin(), encoded.end(), place.begin());
    read_everything(bytes);
  }
}

/// The sample with its second chunk decoded, changed and encoded again; hashes of states and the chain stay as they
/// were.
template <class Change>
Bytes with_changed_chunk(Change change) {
  std::vector<Record> records = sample(sim::Method::kThesis);
  MessageBytes message(records[2].message.size());
  std::copy(records[2].message.begin(), records[2].message.end(), message.bytes().begin());
  Result<ChunkDecoder> chunk = ChunkDecoder::open(message);
  EXPECT_TRUE(chunk.ok());
  Keyframe keyframe = chunk->keyframe();
  std::vector<StepRecord> steps;
  for (std::size_t i = 0; i < chunk->step_count(); ++i) steps.push_back(**chunk->step(i));
  change(keyframe, steps);
  ChunkEncoder encoder;
  const Result<MessageBytes> again = encoder.encode(keyframe, steps);
  EXPECT_TRUE(again.ok());
  records[2].message.assign(again->bytes().begin(), again->bytes().end());
  records[2].prelude.raw_bytes = records[2].message.size();
  records.pop_back();  // the index, which would have another hash of the chunk
  return joined(std::move(records));
}

/// What verify() says of a log that has one damage.
std::string only_damage(const Bytes& bytes) {
  Result<LogReader> log = open_memory(bytes);
  EXPECT_TRUE(log.ok());
  const std::vector<Damage> damages = verify(*log).condition.damages;
  EXPECT_EQ(damages.size(), 1U);
  return damages.empty() ? "" : damages[0].message;
}

using Steps = std::vector<StepRecord>;

TEST(Verify, StatesThatAreNotThoseOfTheirHashAreFound) {
  const Bytes bytes = with_changed_chunk([](Keyframe&, Steps& steps) { steps[3].states.position.x[1] += 0.25; });
  EXPECT_NE(only_damage(bytes).find("step 8 has states with hash"), std::string::npos) << only_damage(bytes);
}

TEST(Verify, AKeyframeThatIsNotTheStepBeforeIsFound) {
  const Bytes bytes = with_changed_chunk([](Keyframe& keyframe, Steps&) { keyframe.state.bodies.spin.x[1] += 0.25; });
  EXPECT_NE(only_damage(bytes).find("the keyframe has state hash"), std::string::npos) << only_damage(bytes);
}

TEST(Verify, AKeyframeWithOtherHiddenStateIsFound) {
  const Bytes bytes =
      with_changed_chunk([](Keyframe& keyframe, Steps&) { keyframe.state.bodies.low_energy_time[1] += 0.25; });
  EXPECT_NE(only_damage(bytes).find("continuation hash"), std::string::npos) << only_damage(bytes);
}

TEST(Verify, AnInputThatIsNotTheChainsIsFound) {
  const Bytes bytes = with_changed_chunk([](Keyframe&, Steps& steps) { steps[0].dt *= 2; });
  EXPECT_NE(only_damage(bytes).find("found chain"), std::string::npos) << only_damage(bytes);
}

TEST(Verify, AnIndexOfOtherChunksIsFound) {
  std::vector<Record> records = sample(sim::Method::kThesis);
  MessageBytes message(records.back().message.size());
  std::copy(records.back().message.begin(), records.back().message.end(), message.bytes().begin());
  std::vector<ChunkPlace> places = *decode_index(message);
  places[1].stored_hash.low ^= 1;
  const Result<MessageBytes> again = encode_index(places);
  records.back().message.assign(again->bytes().begin(), again->bytes().end());
  EXPECT_NE(only_damage(joined(std::move(records))).find("its rows are not the file's chunks"), std::string::npos);
}

}  // namespace
}  // namespace tumble::replay
