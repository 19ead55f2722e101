// Streams of engines that tell what cannot be: what can be kept is kept, and said.
#include <gtest/gtest.h>

#include <limits>

#include "tests/recorder/imported.h"
#include "tests/recorder/recorded.h"

namespace tumble::test {
namespace {

using replay::LogReader;
using replay::StreamImport;
using replay::StreamReader;

TEST(OddStream, NumbersThatNoLogHoldsCostNoSession) {
  const auto odd = [](TumbleRec* rec) {
    TumbleRecBody body = small_cube(9);
    body.mass = std::numeric_limits<double>::quiet_NaN();
    body.friction = -1;
    body.state.position[0] = 1e9;
    std::fill_n(body.state.orientation, 4, 0.0);
    const TumbleRecState first = state_at(1, 1), thrown = state_at(9, 1);
    tumble_rec_body(rec, &body);
    tumble_rec_step_begin(rec, 0.0625);
    tumble_rec_state(rec, 1, &first);
    tumble_rec_state(rec, 9, &thrown);
    ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK);
  };
  const Result<Imported> got = import_bytes(record(1, 0, odd));
  ASSERT_TRUE(got.ok()) << got.error().message;
  EXPECT_EQ(got->import.log.steps, 1U);
  for (const char* text : {"body 9: a mass of nan kg is logged as 1 kg", "body 9: a friction of -1 is logged as 0",
                           "body 9: a coordinate at its start of", "that is no rotation is logged as none"}) {
    EXPECT_TRUE(mentions(got->import.warnings, text)) << text;
  }
}

// A value told twice is the engine's mistake; the steps before it are not lost.
TEST(OddStream, AStepThatCannotBeLeavesTheStepsBefore) {
  const auto twice = [](TumbleRec* rec) {
    std::uint32_t seed = 0;
    tumble_rec_channel(rec, "seed", TUMBLE_REC_WORLD, TUMBLE_REC_F64, &seed);
    for (std::uint64_t k = 1; k <= 2; ++k) {
      const TumbleRecState state = state_at(1, k);
      tumble_rec_step_begin(rec, 0.0625);
      tumble_rec_state(rec, 1, &state);
      for (std::uint64_t told = 0; told < k; ++told) tumble_rec_f64(rec, seed, 0, 1);
      ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK);
    }
  };
  const Result<StreamReader> stream = open_stream(record(1, 0, twice));
  ASSERT_TRUE(stream.ok());
  const auto disk = std::make_shared<replay::Disk>();
  const Result<StreamImport> done = import_stream(*stream, [&]() -> Result<std::unique_ptr<replay::ByteSink>> {
    return std::unique_ptr<replay::ByteSink>(std::make_unique<replay::MemorySink>(disk));
  });
  ASSERT_FALSE(done.ok());
  EXPECT_NE(done.error().message.find("found a second value in one step"), std::string::npos) << done.error().message;
  EXPECT_NE(done.error().message.find("the log holds the steps before, up to 1"), std::string::npos);
  const Result<LogReader> log = replay::open_memory(disk->bytes);
  ASSERT_TRUE(log.ok()) << log.error().message;
  EXPECT_TRUE(log->condition().whole());
  EXPECT_EQ(log->last_step(), 1U);
}

// The place of the log is not touched before the start is known to be sound.
TEST(OddStream, AStartThatCannotBeLeavesAnOlderLog) {
  const auto name_twice = [](TumbleRec* rec) {
    const TumbleRecState state = state_at(1, 1);
    std::uint32_t channel = 0;
    ASSERT_EQ(tumble_rec_channel(rec, "input.go", TUMBLE_REC_WORLD, TUMBLE_REC_BYTES, &channel), TUMBLE_REC_OK);
    ASSERT_EQ(tumble_rec_input(rec, "go", 0, "x", 1), TUMBLE_REC_OK);
    tumble_rec_step_begin(rec, 0.0625);
    tumble_rec_state(rec, 1, &state);
    ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK);
  };
  const Result<StreamReader> stream = open_stream(record(1, 0, name_twice));
  ASSERT_TRUE(stream.ok());
  int opened = 0;
  const auto make_sink = [&]() -> Result<std::unique_ptr<replay::ByteSink>> {
    ++opened;
    return bad_input("notes.txt: exists and is not a log");
  };
  const Result<StreamImport> done = import_stream(*stream, make_sink);
  ASSERT_FALSE(done.ok());
  EXPECT_NE(done.error().message.find("input.go"), std::string::npos) << done.error().message;
  EXPECT_EQ(opened, 0);
  const Result<StreamReader> sound = open_stream(record(1, 2));
  ASSERT_TRUE(sound.ok());
  EXPECT_EQ(import_stream(*sound, make_sink).error().message, "notes.txt: exists and is not a log");
  EXPECT_EQ(opened, 1);
}

}  // namespace
}  // namespace tumble::test
