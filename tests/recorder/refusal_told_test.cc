// A recorder that gives up says why in its stream, where a reader of any version finds a snapshot.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "tests/recorder/imported.h"
#include "tests/recorder/recorded.h"

namespace tumble::test {
namespace {

void tell_twice(TumbleRec* rec) {
  const TumbleRecState state = state_at(1, 3);
  tumble_rec_step_begin(rec, 0.0625);
  tumble_rec_state(rec, 1, &state);
  EXPECT_EQ(tumble_rec_state(rec, 1, &state), TUMBLE_REC_BAD_CALL);
  EXPECT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_BAD_CALL) << "and nothing more is said";
}

const std::string kTwice = "step 3: found two states of body 1 in a step, wanted one";

TEST(RefusalTold, ByTheStreamAndItsLog) {
  const auto hashes = [](TumbleRecDef& def) { def.hashes_only = 1; };
  const auto three = [](TumbleRecDef& def) { def.steps_a_write = 3; };
  for (const std::function<void(TumbleRecDef&)>& change :
       {std::function<void(TumbleRecDef&)>(), std::function<void(TumbleRecDef&)>(hashes),
        std::function<void(TumbleRecDef&)>(three)}) {
    const Result<Imported> got = import_bytes(record(1, 2, tell_twice, change));
    ASSERT_TRUE(got.ok()) << got.error().message;
    EXPECT_EQ(got->log.last_step(), 2U);
    EXPECT_EQ(got->log.header().declared.cut_short, "the recorder gave up after step 2: " + kTwice);
    EXPECT_TRUE(mentions(got->import.warnings, "memory: the recorder gave up after step 2: " + kTwice));
    EXPECT_FALSE(mentions(got->import.warnings, "last frame"));
  }
}

TEST(RefusalTold, OnceAsASnapshotBehindAllThatWasRecorded) {
  const Result<replay::StreamReader> stream = open_stream(record(1, 2, tell_twice));
  ASSERT_TRUE(stream.ok());
  EXPECT_EQ(stream->condition().refusal, kTwice);
  EXPECT_FALSE(stream->condition().finished);
  EXPECT_FALSE(stream->condition().torn);
  EXPECT_FALSE(stream->condition().damage);
  EXPECT_TRUE(stream->snapshots().empty());
  const Result<replay::StreamReader> whole = open_stream(record(1, 2));
  EXPECT_EQ(whole->condition().refusal, "");
}

TEST(RefusalTold, WhereNothingWasRecordedYet) {
  const auto got = import_bytes(record(1, 0, [](TumbleRec* rec) {
    const TumbleRecBody body = small_cube(1);
    EXPECT_EQ(tumble_rec_body(rec, &body), TUMBLE_REC_BAD_CALL);
  }));
  ASSERT_FALSE(got.ok());
  EXPECT_EQ(got.error().message, "memory: has no start: found body 1, wanted an id of 1 to 2^53 - 1 that no body had");
}

// The session is whole, but for the note.
TEST(RefusalTold, OfANoteBehindTheLastStep) {
  const auto got = import_bytes(record(1, 2, [](TumbleRec* rec) { tumble_rec_note(rec, "the end"); }));
  ASSERT_TRUE(got.ok()) << got.error().message;
  EXPECT_EQ(got->log.header().declared.cut_short, "");
  EXPECT_TRUE(mentions(got->import.warnings,
                       "memory: the recorder refused its last call: step 3: found a note after the last step"));
}

TEST(RefusalTold, ByTheDumpOfARing) {
  StreamBytes dumped;
  (void)record(
      1, 2,
      [&](TumbleRec* rec) {
        tell_twice(rec);
        EXPECT_EQ(tumble_rec_dump_to(rec, append, &dumped), TUMBLE_REC_OK);
      },
      [](TumbleRecDef& def) { def.write = nullptr, def.ring_s = 10; });
  const Result<Imported> got = import_bytes(dumped);
  ASSERT_TRUE(got.ok()) << got.error().message;
  EXPECT_EQ(got->log.header().declared.cut_short, "the recorder gave up after step 2: " + kTwice);
}

TEST(RefusalTold, NotBehindTheEnd) {
  StreamBytes bytes;
  TumbleRecDef def = small_def(bytes);
  TumbleRec* rec = tumble_rec_create(&def);
  ASSERT_EQ(tumble_rec_finish(rec), TUMBLE_REC_OK);
  const std::size_t size = bytes.size();
  EXPECT_EQ(tumble_rec_step_begin(rec, 0.0625), TUMBLE_REC_BAD_CALL);
  tumble_rec_close(rec);
  EXPECT_EQ(bytes.size(), size);
}

TEST(RefusalTold, ByNobodyElse) {
  std::string message;
  (void)record(1, 2, [&](TumbleRec* rec) {
    EXPECT_EQ(tumble_rec_snapshot(rec, "tumble_recorder: refused", "x", 1), TUMBLE_REC_BAD_CALL);
    message = tumble_rec_message(rec);
  });
  EXPECT_EQ(message, "step 3: found a snapshot called \"tumble_recorder: refused\", wanted another name");
}

// An earlier run that gave up is a stream to compare with, up to where it goes.
TEST(RefusalTold, ToNoComparison) {
  const std::string path = testing::TempDir() + "refusal_told.tumblestream";
  const auto to_file = [&](TumbleRecDef& def) { def.write = nullptr, def.path = path.c_str(); };
  (void)record(1, 2, tell_twice, to_file);
  (void)record(
      1, 5,
      [](TumbleRec* rec) {
        EXPECT_EQ(tumble_rec_difference(rec), nullptr);
        EXPECT_EQ(tumble_rec_steps_verified(rec), 2U);
      },
      [&](TumbleRecDef& def) { def.verify = path.c_str(); });
  std::remove(path.c_str());
}

}  // namespace
}  // namespace tumble::test
