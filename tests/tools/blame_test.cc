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
}

}  // namespace
}  // namespace tumble::test
