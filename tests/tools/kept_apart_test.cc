// Logs that do not hold the same kinds of things: what both have is compared, and the rest is said to be not compared.
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "replay/recorder/tumble_recorder.h"
#include "tests/support/program.h"

namespace tumble::test {
namespace {

using nlohmann::json;

/// What a stream has.
struct Told {
  TumbleRecType type = TUMBLE_REC_F64;  // of the channel
  std::uint64_t steps = 6;
  double lower = 0;  // m, from step 4 on
  bool channel = true;
  bool hashes_only = false;
  bool is_left = false;   // the recorder is never closed
  bool contacts = false;  // the ground, from step 2 on
};

/// One body that falls; its channel `angle` is 0 or "0".
void import_stream(const Workshop& shop, const std::string& name, const Told& told) {
  TumbleRecDef def = {};
  def.engine = "test engine";
  def.precision_bits = 53;
  const std::string path = shop.path(name + ".tumblestream");
  def.path = path.c_str();
  def.hashes_only = told.hashes_only ? 1 : 0;
  def.steps_a_write = 1;
  TumbleRec* rec = tumble_rec_create(&def);
  TumbleRecBody body = {};
  body.id = 1;
  body.mass = body.size[0] = body.size[1] = body.size[2] = body.state.orientation[0] = 1;
  body.state.position[2] = 5;
  tumble_rec_body(rec, &body);
  std::uint32_t angle = 0;
  if (told.channel) tumble_rec_channel(rec, "angle", TUMBLE_REC_WORLD, told.type, &angle);
  for (std::uint64_t k = 1; k <= told.steps; ++k) {
    tumble_rec_step_begin(rec, 0.01);
    body.state.position[2] = 5 - (k >= 4 ? told.lower : 0);
    tumble_rec_state(rec, 1, &body.state);
    if (told.channel && told.type == TUMBLE_REC_TEXT) tumble_rec_text(rec, angle, 0, "0");
    if (told.channel && told.type == TUMBLE_REC_F64) tumble_rec_f64(rec, angle, 0, 0);
    const TumbleRecPoint point = {{0, 0, 4.5}, 0, 1};
    const TumbleRecContact contact = {1, 0, 0, {0, 0, -1}, &point, 1};
    if (told.contacts && k >= 2) tumble_rec_contact(rec, &contact);
    tumble_rec_step_end(rec);
  }
  if (told.is_left) {
    tumble_rec_step_begin(rec, 0.01);  // a step that does not end
    EXPECT_NE(tumble_rec_close(rec), TUMBLE_REC_OK);
  } else {
    EXPECT_EQ(tumble_rec_close(rec), TUMBLE_REC_OK);
  }
  const Outcome run = shop.run({"import", name + ".tumblestream"});
  ASSERT_EQ(run.exit, 0) << run.err;
}

TEST(KeptApart, OneStepOfAChannelOfAnotherKindIsNotTheSame) {
  const Workshop shop;
  import_stream(shop, "a", {});
  import_stream(shop, "b", {.type = TUMBLE_REC_TEXT});
  const Outcome step = shop.run({"diff", "a.tumble", "b.tumble", "--step", "3"});
  EXPECT_EQ(step.exit, 1) << step.out;
  EXPECT_NE(step.out.find("step 3: different"), std::string::npos) << step.out;
  const json found = json::parse(shop.run({"diff", "a.tumble", "b.tumble", "--step", "3", "--json"}).out);
  EXPECT_EQ(found["same"], false);
  bool named = false;
  for (const json& row : found["values"]) named |= row["name"] == "channel.angle" && row["same"] == false;
  EXPECT_TRUE(named) << found["values"].dump();
}

// An engine that looks at no status of the recorder learns the reason from `import`, and whoever has the log from
// `info`.
TEST(KeptApart, AStreamThatARefusedCallEndedSaysWhy) {
  const Workshop shop;
  import_stream(shop, "left", {.is_left = true});
  const std::string reason = "step 7: was begun but not ended, wanted step_end before the end";
  const Outcome run = shop.run({"import", "left.tumblestream", "-o", "again.tumble"});
  EXPECT_EQ(run.exit, 0);
  EXPECT_NE(run.err.find("left.tumblestream: the recorder gave up after step 6: " + reason), std::string::npos)
      << run.err;
  EXPECT_EQ(run.err.find("tumblestream.tail"), std::string::npos) << "nothing is missing beside it\n" << run.err;
  const json told = json::parse(shop.run({"import", "left.tumblestream", "-o", "again.tumble", "--json"}).out);
  EXPECT_EQ(told["refusal"], reason);
  const Outcome info = shop.run({"info", "again.tumble"});
  EXPECT_NE(info.out.find("the session may have gone on: the recorder gave up after step 6: " + reason),
            std::string::npos)
      << info.out;
  shop.write("tumble.toml", "[engine]\nrun = \"cp left.tumblestream {log}\"\n");
  const Outcome again = shop.run({"replay", "left.tumble"});
  EXPECT_NE(again.out.find("the engine did not end well: the recorder gave up after step 6: " + reason),
            std::string::npos)
      << again.out << again.err;
  import_stream(shop, "whole", {});
  const json whole = json::parse(shop.run({"import", "whole.tumblestream", "-o", "again.tumble", "--json"}).out);
  EXPECT_TRUE(whole["refusal"].is_null());
}

TEST(KeptApart, ContactsThatOneRecorderToldAreNoDifferenceOfAStep) {
  const Workshop shop;
  import_stream(shop, "a", {});
  import_stream(shop, "b", {.contacts = true});
  import_stream(shop, "c", {.lower = 1, .contacts = true});
  const Outcome told = shop.run({"diff", "a.tumble", "b.tumble"});
  EXPECT_EQ(told.exit, 1);
  EXPECT_NE(told.out.find("different in what was recorded: only b.tumble has contacts; the 6 steps of both are the "
                          "same in all else that was compared"),
            std::string::npos)
      << told.out;
  EXPECT_NE(told.out.find("contacts: only the second log has any"), std::string::npos) << told.out;
  EXPECT_EQ(shop.run({"diff", "b.tumble", "a.tumble", "--shared"}).exit, 0);
  EXPECT_EQ(shop.run({"diff", "a.tumble", "b.tumble", "--brief"}).exit, 1);
  EXPECT_EQ(shop.run({"diff", "a.tumble", "b.tumble", "--tolerance", "position=1e-3"}).exit, 0);
  for (const char* brief : {"--json", "--brief"}) {
    const Outcome moved = shop.run({"diff", "a.tumble", "c.tumble", "--json", brief});
    EXPECT_EQ(json::parse(moved.out)["first"]["step"], 4) << moved.out;
  }
  const Outcome moved = shop.run({"diff", "a.tumble", "c.tumble"});
  EXPECT_NE(moved.out.find(" not compared\n  freezing"), std::string::npos) << moved.out;
}

TEST(KeptApart, ASessionThatMayHaveGoneOnIsSaidToBeSo) {
  const Workshop shop;
  import_stream(shop, "a", {});
  import_stream(shop, "b", {.is_left = true});
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"diff", "a.tumble", "b.tumble"},
                                             {"diff", "a.tumble", "b.tumble", "--step", "3"},
                                             {"diff", "a.tumble", "a.tumble", "b.tumble"}}) {
    const Outcome text = shop.run(words);
    EXPECT_NE(text.out.find("b.tumble: its session may have gone on"), std::string::npos) << text.out;
    std::vector<std::string> with_json = words;
    with_json.emplace_back("--json");
    const json found = json::parse(shop.run(with_json).out);
    ASSERT_EQ(found["notes"].size(), 1U) << found.dump();
    EXPECT_NE(found["notes"][0].get<std::string>().find("may have gone on"), std::string::npos);
  }
}

TEST(KeptApart, AmongManyLogsThePairIsNamed) {
  const Workshop shop;
  import_stream(shop, "a", {});
  import_stream(shop, "b", {});
  import_stream(shop, "c", {.channel = false});
  const Outcome diff = shop.run({"diff", "a.tumble", "b.tumble", "c.tumble"});
  EXPECT_EQ(diff.exit, 1) << diff.out;
  EXPECT_NE(diff.out.find("of a.tumble and c.tumble, only a.tumble has channel angle"), std::string::npos) << diff.out;
}

TEST(KeptApart, PlacesOfLogsOfTwoLengthsAreJudgedUpToTheShorterEnd) {
  const Workshop shop;
  import_stream(shop, "a", {});
  import_stream(shop, "b", {.steps = 4});
  import_stream(shop, "c", {.steps = 5, .lower = 0.5});
  EXPECT_EQ(shop.run({"diff", "a.tumble", "b.tumble"}).exit, 1);
  const Outcome near = shop.run({"diff", "a.tumble", "b.tumble", "--apart", "0.1"});
  EXPECT_EQ(near.exit, 0) << near.out;
  EXPECT_NE(near.out.find("apart by at most 0.1 m up to step 4"), std::string::npos) << near.out;
  EXPECT_EQ(shop.run({"diff", "a.tumble", "c.tumble", "--apart", "1"}).exit, 0);
  EXPECT_EQ(shop.run({"diff", "a.tumble", "c.tumble", "--apart", "0.1"}).exit, 1);
}

TEST(KeptApart, HashesAgainstValuesCompareLengthsOfSteps) {
  const Workshop shop;
  import_stream(shop, "values", {});
  import_stream(shop, "hashes", {.hashes_only = true});
  const Outcome diff = shop.run({"diff", "values.tumble", "hashes.tumble"});
  EXPECT_EQ(diff.exit, 1) << diff.out;
  EXPECT_EQ(diff.out.find("different from step"), std::string::npos) << diff.out;
  for (const char* part : {"only values.tumble has values of each step", "only hashes.tumble has hashes of each step",
                           "compared      step lengths", "hashes.tumble holds hashes of them"}) {
    EXPECT_NE(diff.out.find(part), std::string::npos) << part << '\n' << diff.out;
  }
  const Outcome step = shop.run({"diff", "values.tumble", "hashes.tumble", "--step", "2"});
  EXPECT_EQ(step.exit, 1) << step.out;
  EXPECT_EQ(step.out.find("DIFFERENT"), std::string::npos) << step.out;
  EXPECT_NE(step.out.find("only in hashes.tumble: hashes of each step"), std::string::npos) << step.out;
  EXPECT_EQ(shop.run({"diff", "values.tumble", "hashes.tumble", "--apart", "1"}).exit, 2);
  import_stream(shop, "shorter", {.steps = 5, .hashes_only = true});
  EXPECT_EQ(shop.run({"diff", "hashes.tumble", "shorter.tumble", "--apart", "1"}).exit, 2);
  const Outcome shared = shop.run({"diff", "values.tumble", "hashes.tumble", "--shared"});
  EXPECT_EQ(shared.out.find("every bit"), std::string::npos) << shared.out;
}

}  // namespace
}  // namespace tumble::test
