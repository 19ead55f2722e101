// Streams of engines that tell what cannot be: what can be kept is kept, and said.
#include <gtest/gtest.h>
#include <xxhash.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "replay/format/little_endian.h"
#include "replay/stream/stream_format.h"
#include "tests/recorder/imported.h"
#include "tests/recorder/recorded.h"

namespace tumble::test {
namespace {

using replay::LogReader;
using replay::StreamImport;
using replay::StreamReader;

std::vector<std::string> channel_names(const LogReader& log) {
  std::vector<std::string> names;
  for (const replay::Channel& channel : log.header().declared.channels) names.push_back(channel.name);
  return names;
}

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

// Each of these made the whole recording unreadable.
TEST(OddStream, SizesGravityAndTurnsThatCannotBeAreCut) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto odd = [&](TumbleRec* rec) {
    TumbleRecBody ball = small_cube(5), limb = small_cube(6), rod = small_cube(7), box = small_cube(8);
    ball.shape = TUMBLE_REC_SPHERE, ball.size[0] = -2;
    limb.shape = TUMBLE_REC_CAPSULE, limb.size[0] = nan, limb.size[1] = -3;
    rod.shape = TUMBLE_REC_CYLINDER, rod.size[0] = 0, rod.state.orientation[0] = 3;
    box.size[1] = -4;
    for (const TumbleRecBody* body : {&ball, &limb, &rod, &box}) ASSERT_EQ(tumble_rec_body(rec, body), TUMBLE_REC_OK);
  };
  const auto heavy = [&](TumbleRecDef& def) { def.gravity[0] = nan, def.gravity[2] = -1e300; };
  const Result<Imported> got = import_bytes(record(1, 0, odd, heavy));
  ASSERT_TRUE(got.ok()) << got.error().message;
  const replay::LogHeader& header = got->log.header();
  EXPECT_EQ(header.scene.world.gravity, (sim::Vec3{0, 0, -1e4}));
  ASSERT_EQ(header.declared.shapes.size(), 3U);
  EXPECT_EQ(header.declared.shapes[0].radius, 2);
  EXPECT_EQ(header.scene.boxes[1].size, (sim::Vec3{4, 4, 4}));
  EXPECT_EQ(header.scene.boxes[2].size, (sim::Vec3{2, 2, 5}));
  EXPECT_EQ(header.scene.boxes[3].orientation.w, 1);
  EXPECT_EQ(header.scene.boxes[4].size, (sim::Vec3{1, 4, 1}));
  for (const char* text : {"body 5: a radius of -2 m is logged as 2 m", "body 6: a radius of nan m is logged as 1 m",
                           "body 6: a length of -3 m is logged as 3 m", "body 7: a radius of 0 m is logged as 0.0001 m",
                           "body 7: an orientation at its start of length 3 is logged divided by its length",
                           "body 8: an edge of -4 m is logged as 4 m", "a gravity of nan m/s² is logged as 0 m/s²",
                           "is logged as -10000 m/s²"}) {
    EXPECT_TRUE(mentions(got->import.warnings, text)) << text;
  }
}

/// The stream with the right hash in each of its frames.
StreamBytes sealed(StreamBytes bytes) {
  std::uint64_t tag = 0;
  for (std::size_t at = replay::kStreamPreludeBytes; at < bytes.size();) {
    std::byte* const head = bytes.data() + at;
    const std::size_t size = replay::load<std::uint32_t>(head + 4);
    const std::uint64_t hash = XXH64(head + replay::kStreamFrameHeadBytes, size, XXH64(head, 16, tag));
    replay::store(head + 16, hash);
    if (tag == 0) tag = hash;
    at += replay::kStreamFrameHeadBytes + size;
  }
  return bytes;
}

// An older recorder took two phases of one name, and an answer that named the phase was of both.
TEST(OddStream, PhasesOfOneNameAreToldApart) {
  StreamBytes bytes = record(1, 1, {}, [](TumbleRecDef& def) { def.phases = "solve,move,solvX"; });
  const auto name = std::as_bytes(std::span("solvX", 5));
  const auto at = std::search(bytes.begin(), bytes.end(), name.begin(), name.end());
  ASSERT_NE(at, bytes.end());
  at[4] = std::byte{'e'};
  const Result<Imported> got = import_bytes(sealed(bytes));
  ASSERT_TRUE(got.ok()) << got.error().message;
  EXPECT_EQ(got->log.header().phases, (std::vector<std::string>{"solve", "move", "solve#2"}));
  EXPECT_TRUE(mentions(got->import.warnings, "phase 3, \"solve\", is logged as \"solve#2\""));
}

// Names that no log has are mended and said; two channels never become one.
TEST(OddStream, NamesThatNoLogHoldsCostNoSession) {
  const std::string odd[] = {"a=b", "line\nend", "\xff", std::string(200, 'n')};
  const auto named = [&](TumbleRec* rec) {
    std::uint32_t channel = 0;
    tumble_rec_channel(rec, "input.go", TUMBLE_REC_WORLD, TUMBLE_REC_F64, &channel);
    tumble_rec_channel(rec, "bad \xff", TUMBLE_REC_WORLD, TUMBLE_REC_F64, &channel);
    for (const std::string& name : odd) {
      ASSERT_EQ(tumble_rec_input(rec, name.c_str(), 0, name.data(), name.size()), TUMBLE_REC_OK);
    }
    for (const char* bytes : {"1", "2"}) tumble_rec_input(rec, "go", 0, bytes, 1);
    const TumbleRecState state = state_at(1, 1);
    tumble_rec_step_begin(rec, 0.0625);
    tumble_rec_state(rec, 1, &state);
    ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK) << tumble_rec_message(rec);
  };
  const Result<Imported> got = import_bytes(record(1, 0, named));
  ASSERT_TRUE(got.ok()) << got.error().message;
  EXPECT_EQ(channel_names(got->log),
            (std::vector<std::string>{"bad ?", "input.?", "input.a?b", "input.go", "input.go#2", "input.go#3",
                                      "input.line?end", "input." + std::string(194, 'n')}));
  for (const char* text : {"input \"a=b\" is logged as channel \"input.a?b\"", "channel \"input.go\" is logged as"}) {
    EXPECT_TRUE(mentions(got->import.warnings, text)) << text;
  }
}

TEST(OddStream, NamesOfBodiesAndSnapshotsThatNoLogHoldsAreSaid) {
  const auto named = [&](TumbleRec* rec) {
    TumbleRecBody odd = small_cube(5), plain = small_cube(7);
    odd.name = "a\nb", plain.name = "Würfel";
    for (const TumbleRecBody* body : {&odd, &plain}) ASSERT_EQ(tumble_rec_body(rec, body), TUMBLE_REC_OK);
    tumble_rec_step_begin(rec, 0.0625);
    for (const std::uint64_t id : {1U, 5U, 7U}) {
      const TumbleRecState state = state_at(id, 1);
      tumble_rec_state(rec, id, &state);
    }
    ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK);
    ASSERT_EQ(tumble_rec_snapshot(rec, "s\ttate", "x", 1), TUMBLE_REC_OK);
  };
  Result<Imported> got = import_bytes(record(1, 0, named));
  ASSERT_TRUE(got.ok()) << got.error().message;
  EXPECT_EQ(got->log.bodies().name(5), "a?b");
  EXPECT_EQ(got->log.bodies().name(7), "Würfel");
  for (const char* text : {"body 5: the name is logged as \"a?b\": found control characters or bytes that are no text",
                           "a snapshot's name is logged as \"s?tate\""}) {
    EXPECT_TRUE(mentions(got->import.warnings, text)) << text;
  }
  EXPECT_FALSE(mentions(got->import.warnings, "body 7")) << "a name that a log holds";
}

TEST(OddStream, TwoSurfacesOfOneHashAreSaid) {
  const Result<Imported> got = import_bytes(record(1, 0, [](TumbleRec* rec) {
    for (const double high : {1.0, 1.0, 2.0}) {
      const double corners[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, high};
      ASSERT_EQ(tumble_rec_mesh(rec, 77, corners, 4, nullptr, 0), TUMBLE_REC_OK);
    }
  }));
  ASSERT_TRUE(got.ok()) << got.error().message;
  EXPECT_EQ(got->import.warnings,
            std::vector<std::string>{"mesh 77: found two surfaces of one hash; the first is kept"});
}

TEST(OddStream, TwoBodiesOfOneNameAndLeapsOfABodyWithANameAreSaid) {
  const auto named = [&](TumbleRec* rec) {
    TumbleRecBody one = small_cube(5), other = small_cube(7);
    one.name = other.name = "cup";
    for (const TumbleRecBody* body : {&one, &other}) ASSERT_EQ(tumble_rec_body(rec, body), TUMBLE_REC_OK);
    for (int k = 1; k < 20; ++k) {
      tumble_rec_step_begin(rec, 0.0625);
      for (const std::uint64_t id : {1U, 5U, 7U}) {
        TumbleRecState state = state_at(id, 1);
        if (id == 7 && k > 9) state.position[0] += 50;
        tumble_rec_state(rec, id, &state);
      }
      ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK);
    }
  };
  const Result<Imported> got = import_bytes(record(1, 0, named));
  ASSERT_TRUE(got.ok()) << got.error().message;
  EXPECT_TRUE(
      mentions(got->import.warnings, "bodies 5 and 7 are both called \"cup\"; commands that look for one body"));
  EXPECT_TRUE(mentions(got->import.warnings, "body 7 (\"cup\") moves by 50 m in step 10"));
}

// An input called as the second of another input's name has its own channel.
TEST(OddStream, InputsOfNamesThatMeetStayApart) {
  const auto named = [](TumbleRec* rec) {
    for (const auto& [name, bytes] : {std::pair("go#2", "A"), std::pair("go", "B"), std::pair("go", "C")}) {
      tumble_rec_input(rec, name, 0, bytes, 1);
    }
  };
  const Result<Imported> got = import_bytes(record(1, 0, named));
  ASSERT_TRUE(got.ok()) << got.error().message;
  ASSERT_EQ(channel_names(got->log), (std::vector<std::string>{"input.go", "input.go#2", "input.go#3"}));
  const std::vector<replay::ChannelValues>& values = got->log.header().declared.start.channels;
  ASSERT_EQ(values.size(), 3U);
  EXPECT_EQ(values[0].bytes, std::vector<std::string>{"B"});
  EXPECT_EQ(values[1].bytes, std::vector<std::string>{"A"});
  EXPECT_EQ(values[2].bytes, std::vector<std::string>{"C"});
}

/// The orientation of body 1 after steps 1 … 4: of length 1, 1.02 twice (the second time as "same"), 0.
void turn_oddly(TumbleRec* rec) {
  for (const double length : {1.0, 1.02, 1.02, 0.0}) {
    TumbleRecState state = state_at(1, 1);
    state.orientation[0] = length, tumble_rec_step_begin(rec, 0.0625);
    tumble_rec_state(rec, 1, &state);
    ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK);
  }
}

// It is the engine's mistake; it costs no step, and what was told is kept.
TEST(OddStream, AnOrientationThatIsNoRotationCostsNoStep) {
  Result<Imported> got = import_bytes(record(1, 0, turn_oddly));
  ASSERT_TRUE(got.ok()) << got.error().message;
  EXPECT_EQ(got->import.refused, "");
  ASSERT_EQ(got->log.last_step(), 4U);
  EXPECT_TRUE(mentions(got->import.warnings, "step 2: body 1: an orientation of length 1.02 is logged divided by it"));
  EXPECT_TRUE(mentions(got->import.warnings, "step 4: body 1: an orientation that is no rotation is logged as none"));
  const std::size_t channel = got->log.header().declared.find("told.state.orientation.w");
  const std::uint64_t longer = std::bit_cast<std::uint64_t>(1.02);
  const std::vector<std::vector<std::uint64_t>> told = {{}, {longer}, {longer}, {0}};
  for (std::uint64_t k = 1; k <= 4; ++k) {
    const Result<const replay::StepRecord*> step = got->log.read_step(k);
    EXPECT_EQ((*step)->states.orientation[0].w, 1) << k;
    EXPECT_EQ((*step)->extras.values(channel).bits, told[k - 1]) << k;
  }
}

// The place of the log is not touched before the start is known to be sound.
TEST(OddStream, AStartThatCannotBeLeavesAnOlderLog) {
  const auto many_inputs = [](TumbleRec* rec) {
    for (int k = 0; k < 20000; ++k)
      ASSERT_EQ(tumble_rec_input(rec, std::to_string(k).c_str(), 0, "x", 1), TUMBLE_REC_OK);
  };
  const Result<StreamReader> stream = open_stream(record(1, 0, many_inputs));
  ASSERT_TRUE(stream.ok());
  int opened = 0;
  const auto make_sink = [&]() -> Result<std::unique_ptr<replay::ByteSink>> {
    ++opened;
    return bad_input("notes.txt: exists and is not a log");
  };
  const Result<StreamImport> done = import_stream(*stream, make_sink);
  ASSERT_FALSE(done.ok());
  EXPECT_NE(done.error().message.find("found 20000 channels"), std::string::npos) << done.error().message;
  EXPECT_EQ(opened, 0);
  const Result<StreamReader> sound = open_stream(record(1, 2));
  ASSERT_TRUE(sound.ok());
  EXPECT_EQ(import_stream(*sound, make_sink).error().message, "notes.txt: exists and is not a log");
  EXPECT_EQ(opened, 1);
}

/// A stream whose only phase hash is of that substep.
StreamBytes with_substep(std::uint32_t substep) {
  const auto step = [](TumbleRec* rec) {
    const TumbleRecState state = state_at(1, 1);
    tumble_rec_step_begin(rec, 0.0625);
    tumble_rec_state(rec, 1, &state);
    tumble_rec_phase_hash(rec, 0, 7);
    ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK);
  };
  StreamBytes bytes = record(1, 0, step, [](TumbleRecDef& def) { def.phases = "solve"; });
  const replay::StreamFrame frame = open_stream(bytes)->steps().back();
  std::byte* const payload = bytes.data() + frame.offset;
  constexpr std::uint32_t kPhaseRecord = 16U << 8U | static_cast<std::uint32_t>(replay::StreamRecordKind::kPhase);
  for (std::size_t at = 16; at + 20 <= frame.size; ++at) {
    if (replay::load<std::uint32_t>(payload + at) == kPhaseRecord) replay::store(payload + at + 8, substep);
  }
  return sealed(std::move(bytes));
}

// The number of rows of the last possible substep is 0 in 32 bits: the hash was written outside of all rows.
TEST(OddStream, AHashOfASubstepThatNoLogHoldsEndsTheLogBeforeIt) {
  const Result<Imported> last = import_bytes(with_substep(15));
  ASSERT_TRUE(last.ok()) << last.error().message;
  EXPECT_EQ(last->import.refused, "");
  for (const std::uint32_t substep : {16U, 0x7fffffffU, 0xffffffffU}) {
    const Result<Imported> got = import_bytes(with_substep(substep));
    ASSERT_TRUE(got.ok()) << got.error().message;
    EXPECT_EQ(got->import.log.steps, 0U);
    EXPECT_NE(got->import.refused.find("found a phase hash of substep " + std::to_string(substep)), std::string::npos)
        << got->import.refused;
    EXPECT_TRUE(got->log.condition().whole());
    EXPECT_EQ(got->log.header().declared.cut_short, "step 1 of the recorder's stream is none that a log can hold");
  }
}

}  // namespace
}  // namespace tumble::test
