// Lists for people that end early say how many there are.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "replay/recorder/tumble_recorder.h"
#include "tests/support/program.h"

namespace tumble::test {
namespace {

using nlohmann::json;

/// Three bodies, one step. What no scene can hold: three kinds of values, each of every body.
void record_odd(const std::string& path) {
  TumbleRecDef def = {};
  def.engine = "test engine";
  def.precision_bits = 53;
  def.path = path.c_str();
  TumbleRec* rec = tumble_rec_create(&def);
  TumbleRecState states[3] = {};
  for (std::uint64_t id = 1; id <= 3; ++id) {
    TumbleRecBody body = {};
    body.id = id;
    body.size[0] = body.size[1] = body.size[2] = body.state.orientation[0] = 1;
    body.state.position[0] = 3.0 * static_cast<double>(id);
    body.mass = body.friction = body.restitution = -1;
    states[id - 1] = body.state;
    ASSERT_EQ(tumble_rec_body(rec, &body), TUMBLE_REC_OK);
  }
  tumble_rec_step_begin(rec, 0.01);
  for (std::uint64_t id = 1; id <= 3; ++id) tumble_rec_state(rec, id, &states[id - 1]);
  ASSERT_EQ(tumble_rec_step_end(rec), TUMBLE_REC_OK);
  ASSERT_EQ(tumble_rec_close(rec), TUMBLE_REC_OK);
}

TEST(ShownInPart, WarningsOfAReplay) {
  const Workshop shop;
  record_odd(shop.path("odd.tumblestream"));
  const json imported = json::parse(shop.run({"import", "odd.tumblestream", "--json"}).out);
  const std::size_t all = imported["warnings"].size();
  ASSERT_GT(all, 5U);
  shop.write("tumble.toml", "[engine]\nrun = \"cp odd.tumblestream {log}\"\n");
  const Outcome run = shop.run({"replay", "odd.tumble"});
  EXPECT_EQ(run.exit, 0) << run.out << run.err;
  EXPECT_NE(run.err.find("warning: " + std::to_string(all - 5) + " more; 'tumble import' of what the engine writes"),
            std::string::npos)
      << run.err;
}

TEST(ShownInPart, ContactsOfABodyThatDiffers) {
  const Workshop shop;
  std::string scene = "name = \"plate\"\n[world]\nmethod = \"layered\"\n";
  scene += "[[box]]\nsize = [10.0, 10.0, 0.5]\nposition = [0.0, 0.0, 0.25]\nmass = 100.0\n";
  for (int k = 0; k < 12; ++k) {
    scene += "[[box]]\nsize = [1.0, 1.0, 1.0]\nposition = [" + std::to_string(2 * (k % 4) - 3) + ".0, " +
             std::to_string(2 * (k / 4) - 2) + ".0, 1.01]\n";
  }
  shop.write("plate.toml", scene);
  const auto record = [&](const char* name, const char* mass) {
    ASSERT_EQ(shop.run({"record", "plate.toml", "-o", name, "--steps", "3", "--quiet", "--set", mass}).exit, 0);
  };
  record("a.tumble", "box.1.mass=100");
  record("b.tumble", "box.1.mass=101");
  const json found = json::parse(shop.run({"diff", "a.tumble", "b.tumble", "--json"}).out);
  const std::size_t all = found["narrowed"]["contacts"].size();
  ASSERT_GT(all, 8U) << found;
  const Outcome run = shop.run({"diff", "a.tumble", "b.tumble"});
  EXPECT_NE(run.out.find(std::to_string(all - 8) + " more (all with --json)"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace tumble::test
