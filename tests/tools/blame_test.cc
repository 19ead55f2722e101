// `tumble blame` as a person runs it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/program.h"
#include "tests/tools/json_output.h"

namespace tumble::test {
namespace {

using nlohmann::ordered_json;

TEST(BlameCommand, FollowsAThrowToItsLine) {
  const Workshop shop;
  shop.record_small("s");
  const ordered_json dump = parsed(shop.run({"dump", "s.tumble", "--step", "5", "--json"}));
  const std::string thrown = dump["bodies"].back()["id"].dump();
  const Outcome text = shop.run({"blame", "s.tumble", "--body", thrown, "--field", "velocity.y", "--back", "3"});
  ASSERT_EQ(text.exit, 0) << text.err;
  const ordered_json json = parsed(shop.run(
      {"blame", "s.tumble", "--body", thrown, "--field", "velocity.y", "--step", "5", "--back", "9", "--json"}));
  const ordered_json& last = json["answers"].back();
  EXPECT_EQ(last["phase"], "inputs") << json.dump(1);
  EXPECT_EQ(last["step"], 5);
  EXPECT_TRUE(last["before"].is_null());
  EXPECT_TRUE(last["origin"].get<std::string>().find("of the scene, [[input]]") != std::string::npos) << last.dump(1);
  EXPECT_EQ(json["complete"], true);
  const std::string origin = last["origin"];
  const Outcome shown =
      shop.run({"blame", "s.tumble", "--body", thrown, "--field", "velocity.y", "--step", "5", "--back", "9"});
  EXPECT_NE(shown.out.find(origin), std::string::npos) << shown.out;
}

// A damaged log is explained as far as what `recover` makes of it.
TEST(BlameCommand, GoesAsFarInADamagedLogAsInTheRecoveredOne) {
  const Workshop shop;
  ASSERT_EQ(shop.run({"record", "layered_inputs", "-o", "d.tumble", "--quiet"}).exit, 0);
  std::string bytes = shop.read("d.tumble");
  for (std::size_t k = 0; k < 40; ++k) bytes[bytes.size() / 2 + k] ^= 0x55;
  shop.write("d.tumble", bytes);
  ASSERT_LE(shop.run({"recover", "d.tumble", "-o", "r.tumble"}).exit, 3);
  const std::string said = shop.run({"info", "r.tumble"}).out;
  const std::size_t at = said.find(" were lost");
  ASSERT_NE(at, std::string::npos) << said;
  const int last = std::stoi(said.substr(said.rfind(" to ", at) + 4));
  const auto asked = [&](const char* log) {
    return shop.run({"blame", log, "--body", "4", "--field", "velocity.x", "--step", std::to_string(last + 2), "--back",
                     "12", "--json"});
  };
  const Outcome damaged = asked("d.tumble"), recovered = asked("r.tumble");
  EXPECT_EQ(damaged.exit, 3) << damaged.err;
  EXPECT_NE(damaged.err.find("'tumble recover' saves the intact part"), std::string::npos) << damaged.err;
  EXPECT_EQ(parsed(damaged)["answers"], parsed(recovered)["answers"]);
}

// What kept a value as it is looks like no change.
TEST(BlameCommand, SaysThatAValueStayedAsItWas) {
  const Workshop shop;
  ASSERT_EQ(shop.run({"record", "brick_wall", "--steps", "10", "-o", "wall.tumble", "--quiet"}).exit, 0);
  const Outcome shown =
      shop.run({"blame", "wall.tumble", "--body", "1", "--field", "velocity.x", "--step", "10", "--back", "6"});
  ASSERT_EQ(shown.exit, 0) << shown.err;
  EXPECT_NE(shown.out.find("frozen 1, unchanged"), std::string::npos) << shown.out;
  EXPECT_EQ(shown.out.find("1 -> 1"), std::string::npos) << shown.out;
}

TEST(BlameCommand, RefusesWithAReason) {
  const Workshop shop;
  shop.record_small("s");
  const Outcome field = shop.run({"blame", "s.tumble", "--body", "1", "--field", "velocity"});
  EXPECT_EQ(field.exit, 2);
  EXPECT_NE(field.err.find("velocity.x"), std::string::npos) << field.err;
  const Outcome step = shop.run({"blame", "s.tumble", "--body", "1", "--field", "velocity.x", "--step", "41"});
  EXPECT_EQ(step.exit, 2);
  EXPECT_NE(step.err.find("wanted 0 to 40"), std::string::npos) << step.err;
  EXPECT_EQ(shop.run({"blame", "s.tumble", "--field", "velocity.x"}).exit, 2);
  EXPECT_EQ(shop.run({"blame", "s.tumble", "--body", "1", "--field", "velocity.x", "--contacts"}).exit, 2);
  EXPECT_EQ(shop.run({"blame", "s.tumble", "--body", "1", "--step", "0", "--contacts"}).exit, 2);
}

// The impulses of a step's contacts hold what lies on the ground: m g dt.
TEST(BlameCommand, ListsContactsIslandAndLoad) {
  const Workshop shop;
  shop.write("two.toml",
             "[world]\nsteps = 30\nfreezing = false\n[[box]]\nmass = 2.0\nposition = [0.0, 0.0, 0.5]\n"
             "[[box]]\nmass = 3.0\nposition = [0.0, 0.0, 1.5]\n");
  ASSERT_EQ(shop.run({"record", "two.toml", "-o", "two.tumble", "--quiet"}).exit, 0);
  const ordered_json json = parsed(shop.run({"blame", "two.tumble", "--body", "1", "--contacts", "--json"}));
  EXPECT_EQ(json["island"], (ordered_json{1, 2}));
  EXPECT_NEAR(json["borne"].get<double>(), 3.0, 1e-9);
  double from_ground = 0, from_above = 0;
  for (const ordered_json& contact : json["contacts"]) {
    const double impulse = contact["impulse"];
    double points = 0;
    for (const ordered_json& point : contact["points"]) points += point["impulse"].get<double>();
    EXPECT_NEAR(points, impulse, 1e-12);
    EXPECT_NEAR(contact["normal"][2].get<double>(), contact["with"].is_null() ? 1.0 : -1.0, 1e-9);
    (contact["with"].is_null() ? from_ground : from_above) += impulse;
  }
  const double dt = 1.0 / 60, g = 9.81;
  EXPECT_NEAR(from_ground, 5 * g * dt, 1e-6);
  EXPECT_NEAR(from_above, 3 * g * dt, 1e-6);
  const Outcome text = shop.run({"blame", "two.tumble", "--body", "1", "--contacts"});
  EXPECT_NE(text.out.find("the ground"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("2 bodies: 1, 2"), std::string::npos) << text.out;
}

}  // namespace
}  // namespace tumble::test
