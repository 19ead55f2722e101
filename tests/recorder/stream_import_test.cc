// Streams turned into logs: every number to the bit, in our axes, with what was passed over named.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "replay/log/verify.h"
#include "replay/stream/import_stream.h"
#include "tests/recorder/imported.h"
#include "tests/recorder/recorded.h"
#include "tests/support/log_memory.h"
#include "tumble/replay/compare.h"

namespace tumble::test {
namespace {

TEST(StreamImport, StatesComeBackToTheBit) {
  Result<Imported> got = import_bytes(record(3, 6));
  ASSERT_TRUE(got.ok()) << got.error().message;
  EXPECT_EQ(got->import.log.steps, 6U);
  ASSERT_EQ(got->import.warnings.size(), 1U);
  EXPECT_TRUE(mentions(got->import.warnings, "move 2 times as far in a step as their velocities say"));
  EXPECT_EQ(got->log.header().engine->name, "test engine");
  for (std::uint64_t k = 1; k <= 6; ++k) {
    const Result<const replay::StepRecord*> step = got->log.read_step(k);
    ASSERT_TRUE(step.ok()) << step.error().message;
    ASSERT_EQ((*step)->states.size(), 3U);
    EXPECT_EQ((*step)->dt, 0.0625);
    EXPECT_EQ((*step)->states.position[0].z(), state_at(1, k).position[2]) << k;
    EXPECT_EQ((*step)->states.position[1].z(), state_at(2, std::min<std::uint64_t>(k, 3)).position[2]) << k;
    EXPECT_EQ((*step)->states.frozen[1] != 0, k >= 3) << k;
  }
}

// A full disk below an output that takes its name when it is complete.
class FullPart : public replay::ByteSink {
 public:
  Result<std::size_t> write_some(std::span<const std::byte> bytes) override {
    return ++writes_ > 3 ? Result<std::size_t>(cannot_finish("No space left on device")) : bytes.size();
  }
  void truncate(std::uint64_t /*size*/) override {}
  Status sync() override { return {}; }
  [[nodiscard]] std::string name() const override { return "full.tumble"; }
  [[nodiscard]] bool whole_or_nothing() const override { return true; }

 private:
  int writes_ = 0;
};

TEST(StreamImport, AFullDiskUnderAPartOfAnOutputSavesNothing) {
  const Result<replay::StreamReader> stream = open_stream(record(3, 200));
  ASSERT_TRUE(stream.ok()) << stream.error().message;
  const Result<replay::StreamImport> import = replay::import_stream(
      *stream, [] { return Result<std::unique_ptr<replay::ByteSink>>(std::make_unique<FullPart>()); });
  ASSERT_FALSE(import.ok());
  EXPECT_NE(import.error().message.find("no log was written"), std::string::npos) << import.error().message;
}

TEST(StreamImport, NumbersThatAreNoFloatsAndNanAreKept) {
  const double odd[3] = {0.1, -0.0, std::numeric_limits<double>::quiet_NaN()};
  const auto step = [&](TumbleRec* rec) {
    TumbleRecState state = state_at(1, 1);
    std::copy_n(odd, 3, state.position);
    tumble_rec_step_begin(rec, 0.0625);
    tumble_rec_state(rec, 1, &state);
    ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK);
  };
  Result<Imported> got = import_bytes(record(1, 0, step));
  ASSERT_TRUE(got.ok()) << got.error().message;
  EXPECT_TRUE(mentions(got->import.warnings, "step 1: body 1: position.z is nan"));
  const Result<const replay::StepRecord*> read = got->log.read_step(1);
  ASSERT_TRUE(read.ok());
  const sim::Vec3 position = (*read)->states.position[0];
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(static_cast<double>(position[k])), std::bit_cast<std::uint64_t>(odd[k]))
        << k;
  }
}

TEST(StreamImport, AxesAndUnitBecomeOurs) {
  const auto yards = [](TumbleRecDef& def) {
    def.up = 'y';
    def.metres = 0.01;
    def.gravity[1] = -981;
    def.gravity[2] = 0;
  };
  Result<Imported> got = import_bytes(record(1, 1, {}, yards));
  ASSERT_TRUE(got.ok()) << got.error().message;
  EXPECT_NEAR(got->log.header().scene.world.gravity.z(), -9.81, 1e-12);
  const Result<const replay::StepRecord*> step = got->log.read_step(1);
  ASSERT_TRUE(step.ok());
  EXPECT_DOUBLE_EQ((*step)->states.position[0].y(), -0.01 * state_at(1, 1).position[2]);
  EXPECT_EQ(got->log.header().axes().up, 1);
}

TEST(StreamImport, BodiesComeAndGo) {
  const auto more = [](TumbleRec* rec) {
    const TumbleRecBody thrown = small_cube(9);
    const TumbleRecState state = state_at(9, 3);
    const TumbleRecState first = state_at(1, 3);
    tumble_rec_body(rec, &thrown);
    tumble_rec_remove(rec, 2);
    tumble_rec_step_begin(rec, 0.0625);
    tumble_rec_state(rec, 9, &state);
    tumble_rec_state(rec, 1, &first);
    ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK) << tumble_rec_message(rec);
  };
  Result<Imported> got = import_bytes(record(2, 2, more));
  ASSERT_TRUE(got.ok()) << got.error().message;
  const Result<const replay::StepRecord*> step = got->log.read_step(3);
  ASSERT_TRUE(step.ok());
  EXPECT_EQ((*step)->inputs.size(), 2U);
  EXPECT_EQ((*step)->states.id, (std::vector<sim::BodyId>{1, 9}));
}

TEST(StreamImport, ShapesAreKeptBesideTheBoxesAroundThem) {
  const auto sphere = [](TumbleRec* rec) {
    TumbleRecBody body = small_cube(5);
    body.shape = TUMBLE_REC_CAPSULE;
    body.name = "limb\n1";  // a name that no terminal shall print
    body.size[0] = 0.25;
    body.size[1] = 2;
    tumble_rec_body(rec, &body);
  };
  Result<Imported> got = import_bytes(record(1, 0, sphere));
  ASSERT_TRUE(got.ok()) << got.error().message;
  EXPECT_EQ(got->log.header().scene.boxes[1].size, (sim::Vec3{0.5, 0.5, 2.5}));
  ASSERT_EQ(got->log.header().declared.shapes.size(), 1U);
  EXPECT_EQ(got->log.header().declared.shapes[0].radius, 0.25);
  EXPECT_EQ(got->log.header().declared.shapes[0].half_length, 1);
  EXPECT_EQ(got->log.header().declared.bodies[0].name, "limb?1");
}

// A hull and a mesh come with their surface where it was told, and say so where it was not.
TEST(StreamImport, SurfacesAreKeptByTheirHash) {
  const auto solids = [](TumbleRec* rec) {
    const double corners[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const std::uint32_t triangles[6] = {0, 2, 1, 0, 1, 3};
    ASSERT_EQ(tumble_rec_mesh(rec, 77, corners, 4, nullptr, 0), TUMBLE_REC_OK);
    ASSERT_EQ(tumble_rec_mesh(rec, 78, corners, 4, triangles, 2), TUMBLE_REC_OK);
    for (std::uint64_t id = 5; id <= 7; ++id) {
      TumbleRecBody body = small_cube(id);
      body.shape = id == 6 ? TUMBLE_REC_MESH : TUMBLE_REC_HULL;
      body.mesh_hash = 72 + id;
      tumble_rec_body(rec, &body);
    }
  };
  const auto centimetres = [](TumbleRecDef& def) { def.metres = 0.01; };
  Result<Imported> got = import_bytes(record(1, 0, solids, centimetres));
  ASSERT_TRUE(got.ok()) << got.error().message;
  const replay::Declared& declared = got->log.header().declared;
  ASSERT_EQ(declared.shapes.size(), 2U);
  EXPECT_EQ(declared.shapes[0].kind, replay::Shape::Kind::kHull);
  EXPECT_EQ(declared.shapes[0].points[3], (sim::Vec3{0, 0, 0.01}));
  EXPECT_EQ(declared.shapes[1].kind, replay::Shape::Kind::kMesh);
  EXPECT_EQ(declared.shapes[1].triangles, (std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3}));
  EXPECT_TRUE(mentions(got->import.warnings, "body 7: a hull is logged as the box around it"));
  EXPECT_FALSE(mentions(got->import.warnings, "body 5"));
}

TEST(StreamImport, SnapshotsKeepTheirNamesAndRewoundStepsSayWhatBecameOfThem) {
  const auto rewind = [](TumbleRec* rec) {
    const TumbleRecState again = state_at(1, 3);
    ASSERT_EQ(tumble_rec_snapshot(rec, "solver", "abc", 3), TUMBLE_REC_OK);
    ASSERT_EQ(tumble_rec_rewind(rec, 1), TUMBLE_REC_OK) << tumble_rec_message(rec);
    tumble_rec_step_begin(rec, 0.0625);
    tumble_rec_state(rec, 1, &again);
    ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK) << tumble_rec_message(rec);
    ASSERT_EQ(tumble_rec_snapshot(rec, "solver", "xyz", 3), TUMBLE_REC_OK);
  };
  Result<Imported> got = import_bytes(record(1, 2, rewind, [](TumbleRecDef& def) { def.rollback_steps = 4; }));
  ASSERT_TRUE(got.ok()) << got.error().message;
  const Result<const replay::StepRecord*> step = got->log.read_step(2);
  ASSERT_TRUE(step.ok());
  const replay::Extras& extras = (*step)->extras;
  EXPECT_EQ(extras.snapshots.back(), (replay::EngineSnapshot{"solver", "xyz"}));
  ASSERT_EQ(extras.superseded.size(), 1U);
  EXPECT_TRUE(extras.superseded[0].same_inputs);
  EXPECT_EQ(extras.superseded[0].difference, "body 1 position.z: 4.75 → 4.625");
}

TEST(StreamImport, AChannelOutlivesTheStepInWhichItWasDeclared) {
  const auto rewind = [](TumbleRec* rec) {
    std::uint32_t seed = 0;
    const auto step = [&] {
      const TumbleRecState state = state_at(1, 2);
      tumble_rec_step_begin(rec, 0.0625);
      tumble_rec_state(rec, 1, &state);
      tumble_rec_i64(rec, seed, 0, 42);
      ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK) << tumble_rec_message(rec);
    };
    ASSERT_EQ(tumble_rec_channel(rec, "seed", TUMBLE_REC_WORLD, TUMBLE_REC_I64, &seed), TUMBLE_REC_OK);
    step();
    ASSERT_EQ(tumble_rec_rewind(rec, 1), TUMBLE_REC_OK) << tumble_rec_message(rec);
    step();
  };
  Result<Imported> got = import_bytes(record(1, 1, rewind, [](TumbleRecDef& def) { def.rollback_steps = 4; }));
  ASSERT_TRUE(got.ok()) << got.error().message;
  EXPECT_EQ(got->log.header().declared.channels.size(), 1U);
  EXPECT_EQ(got->import.rollbacks.steps[0].second, (replay::Superseded{true, ""}));
}

TEST(StreamImport, ATornStreamSaysWhereItEnds) {
  StreamBytes bytes = record(3, 6);
  bytes.resize(bytes.size() - 40);
  const Result<Imported> got = import_bytes(bytes);
  ASSERT_TRUE(got.ok()) << got.error().message;
  EXPECT_EQ(got->import.log.steps, 5U);
  EXPECT_TRUE(mentions(got->import.warnings, "the recorder was stopped after step 5"));
  EXPECT_EQ(got->log.header().declared.cut_short, "the recorder was stopped after step 5");
  Result<Imported> whole = import_bytes(record(3, 5)), again = import_bytes(bytes);
  ASSERT_TRUE(whole.ok() && again.ok());
  EXPECT_EQ(whole->log.header().declared.cut_short, "");
  const Result<replay::DiffReport> same = replay::diff_logs(whole->log, again->log);
  ASSERT_TRUE(same.ok()) << same.error().message;
  EXPECT_TRUE(same->identical());
  EXPECT_TRUE(mentions(same->notes, "its session may have gone on: the recorder was stopped after step 5"));
}

// The first step after a rewind repeats the state of the last step that was taken back, not of the one before it.
TEST(StreamImport, AStateAfterARewindRefersToNoStepThatWasTakenBack) {
  const auto rewind = [](TumbleRec* rec) {
    const TumbleRecState again = state_at(1, 4);
    tumble_rec_rewind(rec, 2);
    tumble_rec_step_begin(rec, 0.0625);
    tumble_rec_state(rec, 1, &again);
    ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK) << tumble_rec_message(rec);
  };
  Result<Imported> got = import_bytes(record(1, 4, rewind, [](TumbleRecDef& def) { def.rollback_steps = 4; }));
  ASSERT_TRUE(got.ok()) << got.error().message;
  EXPECT_EQ(got->import.log.steps, 3U);
  const Result<const replay::StepRecord*> step = got->log.read_step(3);
  ASSERT_TRUE(step.ok());
  EXPECT_EQ((*step)->states.position[0].z(), state_at(1, 4).position[2]);
}

// Of a ring the log has the steps that were kept, by their own numbers.
TEST(StreamImport, ARingKeepsItsStepNumbers) {
  StreamBytes dumped;
  const auto dump = [&](TumbleRec* rec) {
    ASSERT_EQ(tumble_rec_dump_to(rec, append, &dumped), TUMBLE_REC_OK) << tumble_rec_message(rec);
  };
  const auto ring = [](TumbleRecDef& def) {
    def.write = nullptr;
    def.ring_s = 1;  // 16 steps
  };
  (void)record(2, 100, dump, ring);
  Result<Imported> got = import_bytes(dumped);
  ASSERT_TRUE(got.ok()) << got.error().message;
  EXPECT_EQ(got->log.last_step(), 100U);
  EXPECT_GE(got->import.log.steps, 16U);
  EXPECT_LT(got->import.log.steps, 24U);
  EXPECT_TRUE(replay::verify(got->log).condition.sound());
  const Result<const replay::StepRecord*> step = got->log.read_step(100);
  ASSERT_TRUE(step.ok());
  EXPECT_EQ((*step)->states.position[0].z(), state_at(1, 100).position[2]);
  EXPECT_EQ((*step)->states.position[1].z(), state_at(2, 3).position[2]);
}

TEST(StreamImport, HashesAloneAreCompared) {
  const auto hashes = [](TumbleRecDef& def) { def.hashes_only = 1; };
  Result<Imported> one = import_bytes(record(2, 4, {}, hashes));
  Result<Imported> other = import_bytes(record(3, 4, {}, hashes));
  ASSERT_TRUE(one.ok()) << one.error().message;
  ASSERT_TRUE(other.ok()) << other.error().message;
  EXPECT_EQ(one->log.header().phases.size(), replay::kStreamClasses.size());
  const Result<const replay::StepRecord*> a = one->log.read_step(2);
  const Result<const replay::StepRecord*> b = other->log.read_step(2);
  ASSERT_TRUE(a.ok() && b.ok());
  EXPECT_EQ((*a)->phase_words[0], (*b)->phase_words[0]) << "no inputs in both";
  EXPECT_NE((*a)->phase_words[1], (*b)->phase_words[1]) << "other states";
}

// "Identical" of two of them says that hashes were compared, not values, and no tolerance is judged on them.
TEST(StreamImport, HashesAloneAreSaidToBeHashes) {
  const auto hashes = [](TumbleRecDef& def) { def.hashes_only = 1; };
  Result<Imported> one = import_bytes(record(2, 4, {}, hashes)), again = import_bytes(record(2, 4, {}, hashes));
  ASSERT_TRUE(one.ok() && again.ok());
  const Result<replay::DiffReport> same = replay::diff_logs(one->log, again->log, {});
  ASSERT_TRUE(same.ok()) << same.error().message;
  EXPECT_TRUE(same->identical());
  EXPECT_TRUE(mentions(same->scope.compared,
                       "hashes of inputs, states, contacts, phase hashes and channels of the start and 4 steps"));
  EXPECT_FALSE(mentions(same->scope.compared, "states of 4 steps")) << "there are none";
  EXPECT_TRUE(mentions(same->scope.not_compared, "the recorders kept hashes only"));
  EXPECT_EQ(same->scope.every_bit(), "every compared bit");
  Result<Imported> other = import_bytes(record(3, 4, {}, hashes));
  ASSERT_TRUE(other.ok());
  replay::Tolerances some;
  some.position = 0.5;
  const Result<replay::DiffReport> tolerated = replay::diff_logs(one->log, other->log, some);
  ASSERT_FALSE(tolerated.ok()) << "same within tolerances, of sessions that nobody knows";
  EXPECT_NE(tolerated.error().message.find("holds hashes only"), std::string::npos) << tolerated.error().message;
}

}  // namespace
}  // namespace tumble::test
