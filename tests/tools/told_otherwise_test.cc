// What an engine tells beside its states: nothing of it is lost without a word, and no verdict says "same bits" of it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "replay/recorder/tumble_recorder.h"
#include "tests/support/program.h"

namespace tumble::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A box that falls; a test changes one thing that the recorder is told.
struct Told {
  double x = 0, mass = 1, size = 1, friction = 0.5, gravity = -10, turn = 1;
  double dt_of_7 = 0.0625;
  double push_in_5 = 0, turn_in_5 = 1;  // 0: none
  double normal = 0;                    // of a contact with the ground in step 6, along x; 0: no contact
  std::uint32_t part = 0, points = 0;   // of it
  const char* name = "box";
  const char* phases = "find,solve";
  int precision = 53;
  int ground = 1;
  bool hashes_only = false;
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

void write_session(const Workshop& shop, const std::string& file, const Told& told) {
  const std::string path = shop.path(file);
  TumbleRecDef def = {};
  def.engine = "told";
  def.path = path.c_str();
  def.precision_bits = told.precision;
  def.gravity[2] = told.gravity;
  def.ground = told.ground;
  def.phases = told.phases;
  def.hashes_only = told.hashes_only ? 1 : 0;
  TumbleRec* rec = tumble_rec_create(&def);
  TumbleRecBody body = {};
  body.id = 1;
  body.name = told.name;
  body.mass = told.mass;
  body.size[0] = body.size[1] = body.size[2] = told.size;
  body.friction = told.friction;
  body.state.position[0] = told.x;
  body.state.position[2] = 9;
  body.state.orientation[0] = told.turn;
  tumble_rec_body(rec, &body);
  for (int k = 1; k <= 10; ++k) {
    const double push[3] = {told.push_in_5, 0, 0};
    if (k == 5 && told.push_in_5 != 0) tumble_rec_push(rec, 1, push);
    tumble_rec_step_begin(rec, k == 7 ? told.dt_of_7 : 0.0625);
    TumbleRecState state = body.state;
    state.position[0] = 0;
    state.position[2] -= 0.125 * k;
    state.orientation[0] = k == 5 ? told.turn_in_5 : 1;
    tumble_rec_state(rec, 1, &state);
    const TumbleRecPoint point = {};
    const TumbleRecContact contact = {1, 0, told.part, {told.normal, 0, 0}, &point, told.points};
    if (k == 6 && told.normal != 0) tumble_rec_contact(rec, &contact);
    for (std::uint32_t phase = 0; told.phases != nullptr && phase < 2; ++phase) {
      tumble_rec_phase_hash(rec, phase, static_cast<std::uint64_t>(100 * k) + phase);
    }
    tumble_rec_step_end(rec);
  }
  ASSERT_EQ(tumble_rec_close(rec), TUMBLE_REC_OK);
}

void import_session(const Workshop& shop, const std::string& name, const Told& told) {
  write_session(shop, name + ".tumblestream", told);
  const Outcome imported = shop.run({"import", name + ".tumblestream", "--quiet"});
  ASSERT_EQ(imported.exit, 0) << imported.err;
}

/// A suite whose one case reads the session from s.tumblestream.
void make_case(const Workshop& shop) {
  shop.write("tumble.toml", "[engine]\nrun = '''cp '" + shop.path("s.tumblestream") + "' {log}'''\n");
  shop.write("golden/cases/fall/metrics.toml",
             "[engine]\ntitle = \"falling\"\ncategory = \"toys\"\ninputs = \"inputs.txt\"\n[[metric]]\nname = "
             "\"drift_max\"\nmax = 1e9\n"
             "why = \"a test\"\n");
  shop.write("golden/cases/fall/inputs.txt", "{}\n");
}

void bless_case(const Workshop& shop, const Told& told) {
  make_case(shop);
  write_session(shop, "s.tumblestream", told);
  const Outcome blessed = shop.run({"bless", "fall", "--reason", "a test"});
  ASSERT_EQ(blessed.exit, 0) << blessed.err;
  const Outcome same = shop.run({"check", "--report", "r"});
  EXPECT_EQ(same.exit, 0) << same.out;
  EXPECT_TRUE(has(same.out, "same bits")) << same.out;
}

TEST(ToldOtherwise, TwoSessionsThatWereToldDifferentValuesDiffer) {
  const Workshop shop;
  const auto differ = [&](Told a, Told b, const std::string& named) {
    import_session(shop, "a", a);
    import_session(shop, "b", b);
    const Outcome diff = shop.run({"diff", "a.tumble", "b.tumble"});
    EXPECT_EQ(diff.exit, 1) << named << ": " << diff.out;
    EXPECT_TRUE(has(diff.out + diff.err, named)) << named << ": " << diff.out << diff.err;
  };
  differ({.x = 40000}, {.x = 80000}, "80000");
  differ({.x = kNan}, {.x = 0}, "nan");
  differ({.mass = -1}, {.mass = -5}, "told.mass");
  differ({.mass = kNan}, {.mass = 1}, "told.mass");
  differ({.mass = 1e13}, {.mass = 1e14}, "told.mass");
  differ({.size = 1e6}, {.size = 1e7}, "told.size");
  differ({.gravity = kNan}, {.gravity = 0}, "told.gravity");
  differ({.turn = 0.5}, {.turn = 1}, "told.orientation");
  differ({.turn = 0}, {.turn = 0.5}, "told.orientation");
  differ({.turn_in_5 = 1.02}, {.turn_in_5 = 1.5}, "told.state.orientation.w");
  differ({.turn_in_5 = 1.02}, {}, "told.state.orientation.w");
  differ({.push_in_5 = kNan}, {.push_in_5 = 1}, "impulse.x");
  differ({.push_in_5 = 1e13}, {.push_in_5 = 1e14}, "told.push.x");
  differ({.normal = 1}, {.normal = -1}, "told.ground_contacts");
  differ({.normal = 1}, {}, "told.ground_contacts");
  differ({.normal = 1, .part = 1, .points = 1}, {.normal = 1, .part = 2, .points = 1}, "told.ground_contacts");
}

TEST(ToldOtherwise, ContactsOfPointsAloneNeedNoChannel) {
  const Workshop shop;
  import_session(shop, "a", {.normal = 1, .points = 1});
  const Outcome info = shop.run({"info", "a.tumble"});
  EXPECT_FALSE(has(info.out, "told.")) << info.out;
}

TEST(ToldOtherwise, StateZeroIsAsTold) {
  const Workshop shop;
  import_session(shop, "a", {.x = 40000});
  const Outcome dump = shop.run({"dump", "a.tumble", "--step", "0", "--csv"});
  EXPECT_TRUE(has(dump.out, "40000")) << dump.err << dump.out.substr(0, 1500);
}

TEST(ToldOtherwise, WhatWasCutIsSaid) {
  const Workshop shop;
  import_session(shop, "a", {.mass = -5});
  for (const char* command : {"info", "measure"}) {
    const Outcome said = shop.run({command, "a.tumble"});
    EXPECT_TRUE(has(said.out, "body 1 was told mass -5 at step 0 (channel told.mass)")) << said.out;
  }
}

TEST(ToldOtherwise, WhatCannotBeIsNotBlessed) {
  for (const Told& told :
       {Told{.x = kNan}, Told{.mass = kNan}, Told{.mass = -1}, Told{.gravity = kNan}, Told{.turn = 0.5},
        Told{.friction = -1}, Told{.size = kNan}, Told{.push_in_5 = kNan}, Told{.turn_in_5 = 1.02}}) {
    const Workshop shop;
    make_case(shop);
    write_session(shop, "s.tumblestream", told);
    const Outcome blessed = shop.run({"bless", "fall", "--reason", "a test"});
    EXPECT_EQ(blessed.exit, 2) << blessed.out;
    EXPECT_TRUE(has(blessed.err, "told what cannot be: ") || has(blessed.err, "not finite: body 1")) << blessed.err;
    const Outcome checked = shop.run({"check", "--report", "r"});
    EXPECT_EQ(checked.exit, 1) << checked.out;
  }
}

TEST(ToldOtherwise, CheckFailsAsDiffSays) {
  const Workshop shop;
  bless_case(shop, {});
  const auto fails = [&](const Told& told, const std::string& named) {
    write_session(shop, "s.tumblestream", told);
    const Outcome checked = shop.run({"check", "--report", "r"});
    EXPECT_EQ(checked.exit, 1) << named << ": " << checked.out;
    EXPECT_TRUE(has(checked.out, named)) << named << ": " << checked.out;
    EXPECT_FALSE(has(checked.out, "same bits")) << named << ": " << checked.out;
  };
  fails({.friction = 0.9}, "friction: 0.5 → 0.9");
  fails({.mass = 2}, "body 1 mass: 1 → 2");
  fails({.gravity = -11}, "world.gravity.z: -10 → -11");
  fails({.precision = 24}, "precision: 53 → 24");
  fails({.ground = 0}, "world.ground: true → false");
  fails({.name = "crate"}, "name of body 1: \"box\" → \"crate\"");
  fails({.phases = nullptr}, "phase hashes: find, solve → none");
  fails({.phases = "find,push"}, "phase hashes: find, solve → find, push");
  fails({.dt_of_7 = 0.125}, "before step 7, dt: 0.0625 → 0.125");
  fails({.normal = 1}, "told.ground_contacts");
  write_session(shop, "s.tumblestream", {});
  EXPECT_EQ(shop.run({"check", "--report", "r"}).exit, 0);
}

TEST(ToldOtherwise, HashesAreNoEmptyWorld) {
  const Workshop shop;
  import_session(shop, "h", {.phases = nullptr, .hashes_only = true});
  for (const std::vector<std::string>& command : {std::vector<std::string>{"measure", "h.tumble"},
                                                  {"render", "h.tumble", "-o", "h.png"},
                                                  {"view", "h.tumble", "-o", "h.html"},
                                                  {"export", "h.tumble", "-o", "h.glb"}}) {
    const Outcome refused = shop.run(command);
    EXPECT_EQ(refused.exit, 2) << command.front() << refused.out;
    EXPECT_TRUE(has(refused.err, "holds hashes only, wanted values")) << refused.err;
  }
  make_case(shop);
  write_session(shop, "s.tumblestream", {.phases = nullptr, .hashes_only = true});
  const Outcome blessed = shop.run({"bless", "fall", "--reason", "a test"});
  EXPECT_EQ(blessed.exit, 2);
  EXPECT_TRUE(has(blessed.err, "holds hashes only, wanted values")) << blessed.err;
}

}  // namespace
}  // namespace tumble::test
