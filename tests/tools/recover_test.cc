// tumble recover, run as a person runs it.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <tuple>

#include "tests/support/program.h"

namespace tumble::test {
namespace {

using Json = nlohmann::json;

TEST(RecoverCommand, AWholeLogIsCopiedAndNothingIsLost) {
  const Workshop shop;
  shop.record_small("whole");
  const Outcome outcome = shop.run({"recover", "whole.tumble", "-o", "copy.tumble", "--json"});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_EQ(shop.read("copy.tumble"), shop.read("whole.tumble"));
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["steps"], 40);
  EXPECT_EQ(json["nothing_lost"], true);
  EXPECT_EQ(shop.names_with(".part"), std::vector<std::string>{});
}

TEST(RecoverCommand, WhatIsLostIsSaidAndTheRestReplays) {
  const Workshop shop;
  shop.record_small("torn");
  std::string bytes = shop.read("torn.tumble");
  shop.write("torn.tumble", bytes.substr(0, bytes.size() - 200));  // in the index
  const Outcome outcome = shop.run({"recover", "torn.tumble", "-o", "saved.tumble"});
  EXPECT_EQ(outcome.exit, 3) << outcome.err;
  EXPECT_NE(outcome.out.find("40 steps"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("may have come after step 40"), std::string::npos) << outcome.err;
  EXPECT_EQ(shop.run({"info", "saved.tumble"}).exit, 0);
  EXPECT_EQ(shop.run({"replay", "saved.tumble"}).exit, 0);
}

TEST(RecoverCommand, ALostFooterAloneIsNoLoss) {
  const Workshop shop;
  shop.record_small("torn");
  const std::string bytes = shop.read("torn.tumble");
  shop.write("torn.tumble", bytes.substr(0, bytes.size() - 10));
  const Outcome outcome = shop.run({"recover", "torn.tumble", "-o", "saved.tumble"});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_EQ(shop.read("saved.tumble"), bytes);
  EXPECT_NE(outcome.out.find("nothing of the session; left out: 182 bytes"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("the beginning of the footer"), std::string::npos) << outcome.out;
}

TEST(RecoverCommand, OfTwoLogsInOneFileTheFirstIsKeptAndTheOtherNamed) {
  const Workshop shop;
  shop.record_small("short", {"--steps", "20"});
  shop.record_small("long");
  for (const auto& [first, second, steps] : {std::tuple("short", "long", "40 steps"), {"long", "short", "20 steps"}}) {
    const std::string wanted = shop.read(std::string(first) + ".tumble");
    shop.write("both.tumble", wanted + shop.read(std::string(second) + ".tumble"));
    const Outcome outcome = shop.run({"recover", "both.tumble", "-o", "saved.tumble"});
    EXPECT_EQ(outcome.exit, 3) << outcome.out;
    EXPECT_EQ(shop.read("saved.tumble"), wanted);
    EXPECT_EQ(outcome.out.find("nothing"), std::string::npos) << outcome.out;
    const std::string said = std::string("4 records of another log (") + steps + ")";
    EXPECT_NE(outcome.out.find(said), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
    const Json json = Json::parse(shop.run({"recover", "both.tumble", "-o", "saved.tumble", "--json"}).out);
    EXPECT_EQ(json["nothing_lost"], false);
    EXPECT_EQ(json["other_records"], 4);
    EXPECT_EQ(json["lost_bytes"], shop.read(std::string(second) + ".tumble").size());
  }
  std::string bytes = shop.read("both.tumble");  // the first log's header has a damaged prelude
  bytes[30] ^= 1;
  shop.write("both.tumble", bytes);
  EXPECT_EQ(shop.run({"recover", "both.tumble", "-o", "saved.tumble"}).exit, 3);
  EXPECT_EQ(shop.read("saved.tumble"), shop.read("long.tumble"));
}

TEST(RecoverCommand, TheDamagedLogIsNeverWrittenOver) {
  const Workshop shop;
  shop.record_small("torn");
  const std::string bytes = shop.read("torn.tumble");
  const Outcome same = shop.run({"recover", "torn.tumble", "-o", "./torn.tumble"});
  EXPECT_EQ(same.exit, 2);
  EXPECT_NE(same.err.find("is the damaged log itself"), std::string::npos) << same.err;
  shop.write("scene.toml", "name = \"not a log, and longer than its first bytes\"");
  EXPECT_EQ(shop.run({"recover", "torn.tumble", "-o", "scene.toml"}).exit, 2);
  EXPECT_EQ(shop.read("torn.tumble"), bytes);
}

TEST(RecoverCommand, WhereNothingCanBeSavedNothingIsWritten) {
  const Workshop shop;
  shop.record_small("torn");
  shop.write("torn.tumble", shop.read("torn.tumble").substr(0, 300));
  const Outcome outcome = shop.run({"recover", "torn.tumble", "-o", "saved.tumble"});
  EXPECT_EQ(outcome.exit, 3);
  EXPECT_NE(outcome.err.find("not one whole chunk"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(shop.path("saved.tumble")));
  EXPECT_EQ(shop.names_with(".part"), std::vector<std::string>{});
  shop.write("scene.toml", "name = \"not a log, and longer than its first bytes\"");
  EXPECT_EQ(shop.run({"recover", "scene.toml", "-o", "saved.tumble"}).exit, 2);
}

TEST(RecoverCommand, AFullDiskIsSaidAndADeviceIsRefused) {
  const Workshop shop;
  shop.record_small("whole");
  std::filesystem::create_symlink("/dev/full", shop.path("saved.tumble"));
  const Outcome outcome = shop.run({"recover", "whole.tumble", "-o", "saved.tumble"});
  EXPECT_EQ(outcome.exit, 4);
  EXPECT_NE(outcome.err.find("No space left"), std::string::npos) << outcome.err;
  const Outcome device = shop.run({"recover", "whole.tumble", "-o", "/dev/null"});
  EXPECT_EQ(device.exit, 2);
  EXPECT_NE(device.err.find("found a device"), std::string::npos) << device.err;
}

}  // namespace
}  // namespace tumble::test
