// Sessions of a recorder, compared: no verdict speaks of what the logs do not hold, or of steps that were not asked
// for.
#include <gtest/gtest.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "replay/recorder/tumble_recorder.h"
#include "tests/support/program.h"

namespace tumble::test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

constexpr double kDt = 1.0 / 64;

/// Two bodies, of which the second sleeps.
struct Told {
  const char* engine = "toy";
  const char* phases = nullptr;
  std::vector<std::uint64_t> hashes = {};  // of the phases, in their order
  double mass = 1, x = 9;                  // of the second body
  std::uint64_t steps = 10;
  std::uint64_t moved_from = 1000, asleep_until = 0, contacts_from = 1000;
  bool turned = false;  // the contact is of 2 and 1, not of 1 and the ground
  bool third = false, input = false, hashes_only = false, ring = false;
};

void import_session(const Workshop& shop, const std::string& name, const Told& told) {
  const std::string path = shop.path(name + ".tumblestream");
  TumbleRecDef def = {};
  def.engine = told.engine;
  def.precision_bits = 53;
  def.phases = told.phases;
  def.hashes_only = told.hashes_only ? 1 : 0;
  def.path = told.ring ? nullptr : path.c_str();
  def.ring_s = told.ring ? 1 : 0;
  TumbleRec* rec = tumble_rec_create(&def);
  const auto add = [&](std::uint64_t id, double x, double mass, bool asleep) {
    TumbleRecBody body = {};
    body.id = id;
    body.size[0] = body.size[1] = body.size[2] = body.state.orientation[0] = 1;
    body.mass = mass;
    body.state.position[0] = x;
    body.state.asleep = asleep ? 1 : 0;
    tumble_rec_body(rec, &body);
  };
  add(1, 0, 1, false);
  add(2, told.x, told.mass, true);
  if (told.third) add(3, 20, 1, true);
  if (told.input) tumble_rec_input(rec, "steer", 0, "left", 4);
  for (std::uint64_t k = 1; k <= told.steps; ++k) {
    tumble_rec_step_begin(rec, kDt);
    TumbleRecState state = {};
    state.orientation[0] = 1;
    state.position[0] = k >= told.moved_from ? 100 : 0;
    state.asleep = k <= told.asleep_until ? 1 : 0;
    tumble_rec_state(rec, 1, &state);
    const TumbleRecPoint point = {{0, 0, 0}, 0, 1};
    const std::uint64_t pair[2] = {told.turned ? 2U : 1U, told.turned ? 1U : 0U};
    const TumbleRecContact contact = {pair[0], pair[1], 0, {0, 0, -1}, &point, 1};
    if (k >= told.contacts_from) tumble_rec_contact(rec, &contact);
    for (std::uint32_t phase = 0; phase < told.hashes.size(); ++phase) {
      tumble_rec_phase_hash(rec, phase, told.hashes[phase] + k);
    }
    tumble_rec_step_end(rec);
  }
  if (told.ring) {
    EXPECT_EQ(tumble_rec_dump(rec, path.c_str()), TUMBLE_REC_OK) << tumble_rec_message(rec);
  }
  EXPECT_EQ(tumble_rec_close(rec), TUMBLE_REC_OK);
  const Outcome run = shop.run({"import", name + ".tumblestream", "--quiet"});
  ASSERT_EQ(run.exit, 0) << run.err;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(StreamsCompared, StartsOfTwoStreamsOfHashesAreCompared) {
  const Workshop shop;
  import_session(shop, "a", {.hashes_only = true});
  import_session(shop, "same", {.hashes_only = true});
  const Outcome same = shop.run({"diff", "a.tumble", "same.tumble"});
  EXPECT_EQ(same.exit, 0) << same.out;
  EXPECT_TRUE(has(same.out, "channels of the start and 10 steps")) << same.out;
  for (const Told& told : {Told{.mass = 99, .hashes_only = true}, Told{.x = 500, .hashes_only = true},
                           Told{.third = true, .hashes_only = true}, Told{.input = true, .hashes_only = true}}) {
    import_session(shop, "b", told);
    for (const Words& words : {Words{"diff", "a.tumble", "b.tumble"}, Words{"diff", "b.tumble", "a.tumble", "--brief"},
                               Words{"bisect", "a.tumble", "b.tumble"}}) {
      const Outcome diff = shop.run(words);
      EXPECT_EQ(diff.exit, 1) << diff.out;
      EXPECT_TRUE(has(diff.out, "different from step 0 on")) << diff.out;
      EXPECT_TRUE(has(diff.out, "channel.start.inputs: ")) << diff.out;
    }
  }
}

// Steps of a ring are those that it kept: its start is another one than that of the whole session.
TEST(StreamsCompared, ARingOfHashesIsComparedByItsSteps) {
  const Workshop shop;
  import_session(shop, "whole", {.steps = 300, .hashes_only = true});
  import_session(shop, "ring", {.steps = 300, .hashes_only = true, .ring = true});
  const Outcome diff = shop.run({"diff", "whole.tumble", "ring.tumble"});
  EXPECT_EQ(diff.exit, 0) << diff.out;
  EXPECT_TRUE(has(diff.out, "the start: its bodies, and inputs before the first step")) << diff.out;
  import_session(shop, "moved", {.steps = 300, .moved_from = 290, .hashes_only = true, .ring = true});
  EXPECT_TRUE(has(shop.run({"diff", "whole.tumble", "moved.tumble"}).out, "different from step 290 on"));
}

TEST(StreamsCompared, HashesHaveNoPlacesAndNoMetrics) {
  const Workshop shop;
  import_session(shop, "a", {.hashes_only = true});
  import_session(shop, "far", {.moved_from = 4, .hashes_only = true});
  import_session(shop, "other", {.engine = "other toy", .moved_from = 4, .hashes_only = true});
  for (const char* log : {"far.tumble", "other.tumble"}) {
    const Outcome diff = shop.run({"diff", "a.tumble", log});
    EXPECT_EQ(diff.exit, 1) << diff.out;
    EXPECT_TRUE(has(diff.out, "different from step 4 on")) << diff.out;
    EXPECT_TRUE(has(diff.out, "a log holds hashes and no places of bodies")) << diff.out;
    EXPECT_TRUE(has(diff.out, "effect  not known")) << diff.out;
    for (const char* invented : {"separation", "no metric moved", "none in either log"}) {
      EXPECT_FALSE(has(diff.out, invented)) << diff.out;
    }
  }
  EXPECT_EQ(shop.run({"diff", "a.tumble", "far.tumble", "--apart", "0.001"}).exit, 2);
  EXPECT_EQ(shop.run({"diff", "a.tumble", "a.tumble", "--apart", "0.001"}).exit, 2);
  EXPECT_EQ(shop.run({"dump", "a.tumble", "--step", "3"}).exit, 2);
  const Outcome step = shop.run({"diff", "a.tumble", "far.tumble", "--step", "4"});
  EXPECT_EQ(step.exit, 1) << step.out;
  EXPECT_TRUE(has(step.out, "states not compared")) << step.out;
  EXPECT_FALSE(has(step.out, "kinetic")) << step.out;
}

// An engine may call its phases as the classes of a stream of hashes are called.
TEST(StreamsCompared, ValuesAreNotTakenForHashesByTheNamesOfPhases) {
  const Workshop shop;
  const char* phases = "inputs,states,contacts,phase_hashes,channels";
  import_session(shop, "a", {.phases = phases});
  import_session(shop, "b", {.phases = phases, .moved_from = 4});
  EXPECT_EQ(shop.run({"measure", "a.tumble"}).exit, 0);
  EXPECT_TRUE(has(shop.run({"diff", "a.tumble", "b.tumble", "--apart", "1"}).out, "apart by more than 1 m"));
}

TEST(StreamsCompared, PhasesAreComparedByName) {
  const Workshop shop;
  import_session(shop, "xy", {.phases = "x,y", .hashes = {100, 200}});
  import_session(shop, "yx", {.phases = "y,x", .hashes = {200, 100}});
  import_session(shop, "xyz", {.phases = "x,y,z", .hashes = {100, 200, 300}});
  import_session(shop, "otherwise", {.phases = "y,x", .hashes = {100, 200}});
  import_session(shop, "more", {.phases = "x,y,z", .hashes = {100, 201, 300}});
  const Outcome order = shop.run({"diff", "xy.tumble", "yx.tumble"});
  EXPECT_EQ(order.exit, 1) << order.out;
  EXPECT_TRUE(has(order.out, "header: phases: x, y → y, x")) << order.out;
  EXPECT_TRUE(has(order.out, "different in what was recorded: the two differ in the order of phases")) << order.out;
  EXPECT_EQ(shop.run({"diff", "xy.tumble", "yx.tumble", "--shared"}).exit, 0);
  EXPECT_EQ(shop.run({"bisect", "yx.tumble", "xy.tumble"}).exit, 1);
  for (const char* log : {"otherwise.tumble", "more.tumble"}) {
    for (const Words& words : {Words{"diff", "xy.tumble", log}, Words{"diff", log, "xy.tumble", "--shared"},
                               Words{"diff", log, "xy.tumble", "--brief"}, Words{"bisect", "xy.tumble", log}}) {
      const Outcome diff = shop.run(words);
      EXPECT_EQ(diff.exit, 1) << diff.out;
      EXPECT_TRUE(has(diff.out, "different from step 1 on")) << diff.out;
      EXPECT_TRUE(has(diff.out, "phase_hash")) << diff.out;
    }
  }
  const Outcome shared = shop.run({"diff", "xyz.tumble", "xy.tumble", "--shared"});
  EXPECT_EQ(shared.exit, 0) << shared.out;
  EXPECT_TRUE(has(shared.out, ", phase hashes")) << shared.out;
  EXPECT_TRUE(has(shared.out, "hashes of the phases that one log alone has")) << shared.out;
  shop.write("tumble.toml", "[engine]\nrun = \"cp otherwise.tumblestream {log}\"\n");
  EXPECT_EQ(shop.run({"replay", "xy.tumble"}).exit, 1);
  shop.write("tumble.toml", "[engine]\nrun = \"cp yx.tumblestream {log}\"\n");
  EXPECT_EQ(shop.run({"replay", "xy.tumble"}).exit, 1);
}

TEST(StreamsCompared, ASessionThatEndsBeforeTheTimeAskedForIsShorter) {
  const Workshop shop;
  import_session(shop, "short", {.steps = 5});
  import_session(shop, "long", {.steps = 20});
  for (const Words& words : {Words{"diff", "short.tumble", "long.tumble", "--until", "0.25"},
                             Words{"diff", "long.tumble", "short.tumble", "--until", "0.25"}}) {
    const Outcome diff = shop.run(words);
    EXPECT_EQ(diff.exit, 1) << diff.out;
    EXPECT_TRUE(has(diff.out, "different in length")) << diff.out;
    EXPECT_TRUE(has(diff.out, "goes on to step 16, the last that was asked for")) << diff.out;
  }
  EXPECT_EQ(shop.run({"diff", "short.tumble", "long.tumble", "--until", "0.05"}).exit, 0);
  EXPECT_EQ(shop.run({"diff", "long.tumble", "short.tumble", "--until", "0.05"}).exit, 0);
}

TEST(StreamsCompared, NothingBehindTheTimeAskedForIsReported) {
  const Workshop shop;
  import_session(shop, "a", {.steps = 20});
  import_session(shop, "b", {.mass = 3, .steps = 20, .moved_from = 18, .contacts_from = 18});
  const Outcome same = shop.run({"diff", "a.tumble", "b.tumble", "--until", "0.25"});
  EXPECT_EQ(same.exit, 0) << same.out << "the contacts of step 18 were not asked for";
  import_session(shop, "c", {.steps = 20, .moved_from = 18, .asleep_until = 3});
  const json found = json::parse(shop.run({"diff", "a.tumble", "c.tumble", "--until", "0.25", "--json"}).out);
  EXPECT_EQ(found["first"]["step"], 1);
  EXPECT_EQ(found["aftermath"]["last"]["step"], 16);
  EXPECT_EQ(found["aftermath"]["largest"]["gap"], 0);
  for (const json& metric : found["aftermath"]["metrics"]) EXPECT_NE(metric["name"], "drift_max") << metric;
  const Outcome text = shop.run({"diff", "a.tumble", "c.tumble", "--until", "0.25"});
  EXPECT_TRUE(has(text.out, "not compared: all behind step 16, as asked")) << text.out;
  import_session(shop, "d", {.contacts_from = 3});
  import_session(shop, "e", {.contacts_from = 3, .turned = true});
  EXPECT_TRUE(
      has(shop.run({"diff", "d.tumble", "e.tumble", "--until", "0.1"}).out, "effect  in no state up to step 6"));
}

TEST(StreamsCompared, WhatWasBeforeTheFirstDifferenceIsNotSaidToBeNothing) {
  const Workshop shop;
  import_session(shop, "a", {.asleep_until = 2});
  import_session(shop, "b", {.moved_from = 5, .asleep_until = 2});
  const Outcome diff = shop.run({"diff", "a.tumble", "b.tumble"});
  EXPECT_TRUE(has(diff.out, "none in either log from step 5 on")) << diff.out;
}

TEST(StreamsCompared, AContactOfOneLogIsNamedAndNotCounted) {
  const Workshop shop;
  import_session(shop, "a", {.contacts_from = 3});
  import_session(shop, "b", {.contacts_from = 3, .turned = true});
  const Outcome diff = shop.run({"diff", "a.tumble", "b.tumble"});
  EXPECT_TRUE(has(diff.out, "came out otherwise: contact of 1 and the ground: only the first log has")) << diff.out;
}

TEST(StreamsCompared, AHeaderOfACutValueIsSaidToBeCut) {
  const Workshop shop;
  import_session(shop, "a", {.mass = 1e300});
  import_session(shop, "b", {});
  const Outcome diff = shop.run({"diff", "a.tumble", "b.tumble"});
  EXPECT_TRUE(has(diff.out, "note: a.tumble: the scene of the log is cut to what a scene can hold: body 2"))
      << diff.out;
}

TEST(StreamsCompared, NoLengthOfStepsIsInventedForASessionWithoutSteps) {
  const Workshop shop;
  import_session(shop, "a", {});
  import_session(shop, "none", {.steps = 0});
  const Outcome diff = shop.run({"diff", "a.tumble", "none.tumble"});
  EXPECT_EQ(diff.exit, 1) << diff.out;
  EXPECT_FALSE(has(diff.out, "world.dt")) << diff.out;
  EXPECT_TRUE(has(shop.run({"info", "none.tumble"}).out, "not told: there is no step"));
}

}  // namespace
}  // namespace tumble::test
