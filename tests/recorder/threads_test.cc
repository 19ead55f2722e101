// Two threads on one recorder: an error, wherever they meet, and never a torn frame.
#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>

#include "tests/recorder/recorded.h"

namespace tumble::test {
namespace {

struct Begun {
  StreamBytes bytes;
  TumbleRecDef def = small_def(bytes);
  TumbleRec* rec = tumble_rec_create(&def);
  Begun() {
    const TumbleRecBody body = small_cube(1);
    tumble_rec_body(rec, &body);
  }
  ~Begun() { tumble_rec_close(rec); }
  Begun(const Begun&) = delete;
  Begun& operator=(const Begun&) = delete;
};

TEST(RecorderThreads, AnotherThreadWithinAStepIsAnError) {
  Begun begun;
  const TumbleRecState state = state_at(1, 1);
  ASSERT_EQ(tumble_rec_step_begin(begun.rec, 0.1), TUMBLE_REC_OK);
  TumbleRecStatus other = TUMBLE_REC_OK;
  std::thread([&] { other = tumble_rec_state(begun.rec, 1, &state); }).join();
  EXPECT_EQ(other, TUMBLE_REC_TWO_THREADS);
  EXPECT_EQ(tumble_rec_step_end(begun.rec), TUMBLE_REC_TWO_THREADS);
  EXPECT_NE(std::string(tumble_rec_message(begun.rec)).find("a second thread"), std::string::npos);
}

TEST(RecorderThreads, AStepEachIsFine) {
  Begun begun;
  for (std::uint64_t k = 1; k <= 4; ++k) {
    std::thread([&] {
      const TumbleRecState state = state_at(1, k);
      tumble_rec_step_begin(begun.rec, 0.1);
      tumble_rec_state(begun.rec, 1, &state);
      EXPECT_EQ(tumble_rec_step_end(begun.rec), TUMBLE_REC_OK) << tumble_rec_message(begun.rec);
    }).join();
  }
  EXPECT_EQ(tumble_rec_finish(begun.rec), TUMBLE_REC_OK);
}

// Threads that call at once until both are told so; what was written before reads whole.
TEST(RecorderThreads, TwoAtOnceAreBothTold) {
  Begun begun;
  std::atomic<int> told = 0;
  const auto hammer = [&] {
    for (;;) {
      const TumbleRecStatus status = tumble_rec_note(begun.rec, "a note");
      if (status == TUMBLE_REC_OK) continue;
      told += status == TUMBLE_REC_TWO_THREADS ? 1 : 0;
      return;
    }
  };
  std::thread one(hammer), two(hammer);
  one.join();
  two.join();
  EXPECT_EQ(told, 2);
  EXPECT_EQ(tumble_rec_finish(begun.rec), TUMBLE_REC_TWO_THREADS);
  const Result<replay::StreamReader> stream = open_stream(begun.bytes);
  ASSERT_TRUE(stream.ok()) << stream.error().message;
  EXPECT_FALSE(stream->condition().damage);
}

TEST(RecorderThreads, ACallbackMayNotRecord) {
  StreamBytes bytes;
  struct Callback {
    TumbleRec* rec = nullptr;
    TumbleRecStatus found = TUMBLE_REC_OK;
  } callback;
  TumbleRecDef def = small_def(bytes);
  def.write_user = &callback;
  def.write = [](void* user, const void*, std::size_t) {
    auto* self = static_cast<Callback*>(user);
    if (self->rec != nullptr) self->found = tumble_rec_note(self->rec, "from within");
    return 0;
  };
  TumbleRec* rec = tumble_rec_create(&def);
  callback.rec = rec;
  tumble_rec_step_begin(rec, 0.1);
  EXPECT_EQ(callback.found, TUMBLE_REC_BAD_CALL);
  EXPECT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK);
  tumble_rec_close(rec);
}

}  // namespace
}  // namespace tumble::test
