// What a recorder tells beside states comes into the log, and a difference in it is found: joint angle, seed, control.
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/recorder/recorded.h"
#include "tests/support/program.h"

namespace tumble::test {
namespace {

/// One number that differs from step 3 on.
struct Change {
  const char* name = "";
  float angle = 0;
  std::uint64_t seed = 0;
  double control = 0;
  double impulse = 0;
  const char* button = "jump";
};

void tell(TumbleRec* rec, std::uint64_t k, const std::uint32_t* channels, const Change& change) {
  const bool late = k >= 3;
  const float angle = 0.25F + (late ? change.angle : 0);
  const std::uint64_t seed = 42 + (late ? change.seed : 0);
  const double controls[2] = {0.5, 0.75 + (late ? change.control : 0)};
  TumbleRecPoint point = {};
  point.impulse = 4 + (late ? change.impulse : 0);
  const TumbleRecContact contact = {2, 1, 0, {0, 0, 1}, &point, 1};
  tumble_rec_value(rec, channels[0], 1, 2, &angle, 1);
  tumble_rec_value(rec, channels[1], 0, 0, &seed, 1);
  tumble_rec_value(rec, channels[2], 0, 0, controls, 2);
  tumble_rec_contact(rec, &contact);
  tumble_rec_note(rec, change.name);
}

StreamBytes session(const Change& change) {
  StreamBytes bytes;
  const TumbleRecDef def = small_def(bytes);
  TumbleRec* rec = tumble_rec_create(&def);
  std::uint32_t channels[3];
  tumble_rec_channel(rec, "joint.angle", TUMBLE_REC_OF_PAIR, TUMBLE_REC_F32, &channels[0]);
  tumble_rec_channel(rec, "random.seed", TUMBLE_REC_WORLD, TUMBLE_REC_U64, &channels[1]);
  tumble_rec_channel(rec, "control", TUMBLE_REC_WORLD, TUMBLE_REC_F64, &channels[2]);
  for (std::uint64_t id = 1; id <= 2; ++id) {
    TumbleRecBody body = small_cube(id);
    body.name = id == 1 ? "thigh" : "shin";
    body.shape = TUMBLE_REC_CAPSULE;
    tumble_rec_body(rec, &body);
  }
  for (std::uint64_t k = 1; k <= 5; ++k) {
    if (k == 4) tumble_rec_input(rec, "button", 0, change.button, 4);
    tumble_rec_step_begin(rec, 0.0625);
    for (std::uint64_t id = 1; id <= 2; ++id) {
      const TumbleRecState state = state_at(id, k);
      tumble_rec_state(rec, id, &state);
    }
    tell(rec, k, channels, change);
    tumble_rec_step_end(rec);
  }
  EXPECT_EQ(tumble_rec_close(rec), TUMBLE_REC_OK);
  return bytes;
}

class StreamChannels : public testing::Test {
 protected:
  void import(const std::string& name, const Change& change) const {
    const StreamBytes bytes = session(change);
    shop_.write(name + ".tumblestream", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    const Outcome imported = shop_.run({"import", name + ".tumblestream", "-o", name + ".tumble", "--json"});
    ASSERT_EQ(imported.exit, 0) << imported.err;
    EXPECT_TRUE(nlohmann::json::parse(imported.out)["passed_over"].empty()) << imported.out;
    EXPECT_EQ(shop_.run({"info", name + ".tumble"}).exit, 0);
  }

  /// diff of a session without and one with the change: the step and the field that it names.
  void expect_found(const Change& change, int step, const std::string& field) const {
    import("changed", change);
    const Outcome diff = shop_.run({"diff", "one.tumble", "changed.tumble", "--json"});
    ASSERT_EQ(diff.exit, 1) << change.name << diff.out << diff.err;
    const auto first = nlohmann::json::parse(diff.out)["first"];
    EXPECT_EQ(first["step"], step) << change.name << diff.out;
    EXPECT_NE(first["field"].get<std::string>().find(field), std::string::npos) << change.name << diff.out;
  }

  Workshop shop_;
};

TEST_F(StreamChannels, EqualSessionsAreIdentical) {
  import("one", {"a first run"});
  import("two", {"a second run"});  // notes are not compared
  const Outcome diff = shop_.run({"diff", "one.tumble", "two.tumble"});
  EXPECT_EQ(diff.exit, 0) << diff.out << diff.err;
}

TEST_F(StreamChannels, AngleSeedControlContactAndInputThatDifferAreFound) {
  import("one", {"one"});
  expect_found({.name = "angle", .angle = 0.125F}, 3, "joint.angle");
  expect_found({.name = "seed", .seed = 1}, 3, "random.seed");
  expect_found({.name = "control", .control = 1e-9}, 3, "control[1]");
  expect_found({.name = "impulse", .impulse = 1}, 3, "impulse");
  expect_found({.name = "button", .button = "walk"}, 4, "input.button");
}

TEST_F(StreamChannels, DumpShowsNamesShapesAndValues) {
  import("one", {"one"});
  const Outcome dump = shop_.run({"dump", "one.tumble", "--steps", "3:3"});
  ASSERT_EQ(dump.exit, 0) << dump.err;
  for (const char* part : {"thigh", "shin", "joint.angle", "random.seed", "control[1]"}) {
    EXPECT_NE(dump.out.find(part), std::string::npos) << part << '\n' << dump.out;
  }
}

}  // namespace
}  // namespace tumble::test
