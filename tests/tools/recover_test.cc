// tumble recover, run as a person runs it.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

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
