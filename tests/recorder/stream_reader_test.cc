// The frames of a stream: whole, cut, changed, rewound.
#include "replay/stream/stream_reader.h"

#include <gtest/gtest.h>

#include <span>

#include "tests/recorder/recorded.h"

namespace tumble::test {
namespace {

using replay::StreamFrame;
using replay::StreamReader;

TEST(StreamReader, ReadsWhatWasRecorded) {
  const Result<StreamReader> stream = open_stream(record(3, 4));
  ASSERT_TRUE(stream.ok()) << stream.error().message;
  EXPECT_EQ(stream->header().engine.name, "test engine");
  EXPECT_EQ(stream->header().engine.precision_bits, 24U);
  EXPECT_EQ(stream->header().gravity.z(), -10);
  EXPECT_TRUE(stream->condition().finished);
  EXPECT_FALSE(stream->condition().torn || stream->condition().damage);
  ASSERT_EQ(stream->steps().size(), 5U);
  for (std::uint64_t k = 0; k < 5; ++k) EXPECT_EQ(stream->steps()[k].step, k);
}

// A kill may cut the file at any byte: no frame that was complete may be missing.
TEST(StreamReader, CutAnywhereKeepsEveryCompleteFrame) {
  const StreamBytes whole = record(3, 4);
  const Result<StreamReader> all = open_stream(whole);
  ASSERT_TRUE(all.ok());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Result<StreamReader> cut = open_stream(StreamBytes(whole.begin(), whole.begin() + static_cast<long>(size)));
    std::size_t complete = 0;
    for (const StreamFrame& frame : all->steps()) complete += frame.offset + frame.size <= size ? 1 : 0;
    if (!cut.ok()) {
      EXPECT_EQ(complete, 0U) << size << ": " << cut.error().message;
      continue;
    }
    EXPECT_EQ(cut->steps().size(), complete) << size;
    EXPECT_FALSE(cut->condition().finished) << size;
    EXPECT_FALSE(cut->condition().damage) << size << ": " << cut->condition().damage.value_or("");
    EXPECT_EQ(cut->condition().torn, size != cut->condition().good_bytes) << size;
  }
}

TEST(StreamReader, AFlippedBitAnywhereIsFound) {
  const StreamBytes whole = record(3, 4);
  for (std::size_t at = 0; at < whole.size(); ++at) {
    if (at >= 20 && at < 24) continue;  // the minor version, which readers ignore
    StreamBytes hurt = whole;
    hurt[at] ^= std::byte{16};
    const Result<StreamReader> stream = open_stream(hurt);
    if (!stream.ok()) continue;
    EXPECT_TRUE(stream->condition().damage || stream->condition().torn) << "byte " << at;
    EXPECT_LE(stream->condition().good_bytes, at) << "byte " << at;
  }
}

TEST(StreamReader, AFrameOfAnotherStreamIsDamage) {
  StreamBytes one = record(3, 4);
  const StreamBytes other = record(3, 4, {}, [](TumbleRecDef& def) { def.version = "1"; });
  const Result<StreamReader> read_one = open_stream(one);
  const Result<StreamReader> read_other = open_stream(other);
  ASSERT_TRUE(read_one.ok() && read_other.ok());
  const StreamFrame& to = read_one->steps()[2];
  const StreamFrame& from = read_other->steps()[2];
  ASSERT_EQ(to.size, from.size);
  const std::size_t head = replay::kStreamFrameHeadBytes;
  std::copy_n(other.begin() + static_cast<long>(from.offset - head), from.size + head,
              one.begin() + static_cast<long>(to.offset - head));
  const Result<StreamReader> mixed = open_stream(one);
  ASSERT_TRUE(mixed.ok());
  ASSERT_TRUE(mixed->condition().damage);
  EXPECT_NE(mixed->condition().damage->find("a frame whose hash is wrong"), std::string::npos);
  EXPECT_EQ(mixed->steps().size(), 2U);
}

TEST(StreamReader, ARewindSupersedesSteps) {
  const auto rewind = [](TumbleRec* rec) {
    ASSERT_EQ(tumble_rec_rewind(rec, 2), TUMBLE_REC_OK) << tumble_rec_message(rec);
    for (std::uint64_t k = 3; k <= 6; ++k) {
      tumble_rec_step_begin(rec, 0.0625);
      for (std::uint64_t id = 1; id <= 3; ++id) {
        const TumbleRecState state = state_at(id, k);
        tumble_rec_state(rec, id, &state);
      }
      ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK) << tumble_rec_message(rec);
    }
  };
  const Result<StreamReader> stream =
      open_stream(record(3, 4, rewind, [](TumbleRecDef& def) { def.rollback_steps = 2; }));
  ASSERT_TRUE(stream.ok()) << stream.error().message;
  EXPECT_EQ(stream->rewinds(), 1U);
  ASSERT_EQ(stream->steps().size(), 7U);
  ASSERT_EQ(stream->superseded().size(), 2U);
  for (const replay::SupersededStep& pair : stream->superseded()) {
    EXPECT_EQ(pair.before.step, pair.after.step);
    EXPECT_LT(pair.before.offset, pair.after.offset);
  }
  EXPECT_EQ(stream->superseded()[0].before.step, 3U);
}

// Steps that wait for one another are written by flush, by an error and at the end, and read as any.
TEST(StreamReader, StepsOfOneWriteAreAllThere) {
  const auto several = [](TumbleRecDef& def) { def.steps_a_write = 4; };
  EXPECT_EQ(record(3, 10, {}, several), record(3, 10)) << "the same bytes";
  StreamBytes bytes;
  TumbleRecDef def = small_def(bytes);
  def.steps_a_write = 100;
  TumbleRec* rec = tumble_rec_create(&def);
  const TumbleRecBody body = small_cube(1);
  tumble_rec_body(rec, &body);
  const auto step = [&] {
    const TumbleRecState state = state_at(1, tumble_rec_step(rec));
    tumble_rec_step_begin(rec, 0.0625);
    tumble_rec_state(rec, 1, &state);
    tumble_rec_step_end(rec);
  };
  step();
  const std::size_t begun = bytes.size();
  step();
  EXPECT_EQ(bytes.size(), begun);
  EXPECT_EQ(tumble_rec_flush(rec), TUMBLE_REC_OK);
  const std::size_t flushed = bytes.size();
  EXPECT_GT(flushed, begun);
  step();
  EXPECT_EQ(tumble_rec_note(rec, ""), TUMBLE_REC_BAD_CALL);
  EXPECT_GT(bytes.size(), flushed) << "what was recorded before an error stays";
  tumble_rec_close(rec);
  const Result<replay::StreamReader> stream = open_stream(bytes);
  ASSERT_TRUE(stream.ok()) << stream.error().message;
  EXPECT_EQ(stream->steps().back().step, 3U);
}

}  // namespace
}  // namespace tumble::test
