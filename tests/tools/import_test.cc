// Logs of other engines as a user meets them: import, what works with them, and what replay says.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/program.h"

namespace tumble::test {
namespace {

void dump_and_import(const Workshop& shop, const std::vector<std::string>& more) {
  shop.record_small("ours");
  const Outcome dumped = shop.run({"dump", "ours.tumble", "--steps", "0:40", "--csv"});
  ASSERT_EQ(dumped.exit, 0) << dumped.err;
  shop.write("table.csv", "# engine: mine\n" + dumped.out);
  std::vector<std::string> arguments = {"import", "table.csv", "--json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome imported = shop.run(arguments);
  ASSERT_EQ(imported.exit, 0) << imported.err;
  const auto json = nlohmann::json::parse(imported.out);
  EXPECT_EQ(json["engine"], "mine");
  EXPECT_EQ(json["steps"], 40);
}

TEST(Import, WhatWasDumpedComparesAsIdentical) {
  const Workshop shop;
  dump_and_import(shop, {"--like", "ours.tumble"});
  const Outcome diff = shop.run({"diff", "ours.tumble", "table.tumble"});
  EXPECT_EQ(diff.exit, 0) << diff.out << diff.err;
  EXPECT_EQ(shop.run({"info", "table.tumble"}).exit, 0);
  EXPECT_EQ(shop.run({"measure", "table.tumble"}).exit, 0);
}

TEST(Import, ReplaySaysWhoWroteTheLog) {
  const Workshop shop;
  dump_and_import(shop, {"--header", "dt: 0.01"});
  const Outcome replayed = shop.run({"replay", "table.tumble"});
  EXPECT_EQ(replayed.exit, 2);
  EXPECT_NE(replayed.err.find("this log was written by mine; it cannot be replayed, only compared"), std::string::npos)
      << replayed.err;
  EXPECT_EQ(shop.run({"record", "--from", "table.tumble:3"}).exit, 2);
}

TEST(Import, BadTablesAndArgumentsAreStatusTwo) {
  const Workshop shop;
  shop.write("bad.csv", "# dt: 0.1\nstep,id\n");
  const Outcome bad = shop.run({"import", "bad.csv", "-o", "bad.tumble"});
  EXPECT_EQ(bad.exit, 2);
  EXPECT_NE(bad.err.find("bad.csv:2:1: found 0 columns of position"), std::string::npos) << bad.err;
  EXPECT_EQ(shop.run({"info", "bad.tumble"}).exit, 2) << "no log must be there";
  EXPECT_EQ(shop.run({"import", "missing.csv"}).exit, 2);
  EXPECT_EQ(shop.run({"import", "bad.csv", "--like", "missing.tumble"}).exit, 2);
}

TEST(Import, KnowsALogAndTheBeginningOfAStream) {
  const Workshop shop;
  shop.record_small("s");
  shop.write("w.csv", shop.read("s.tumble"));
  const Outcome log = shop.run({"import", "w.csv", "-o", "x.tumble"});
  EXPECT_EQ(log.exit, 2);
  EXPECT_NE(log.err.find("w.csv: is a log of Tumble already"), std::string::npos) << log.err;
  shop.write("cut.tumblestream", "\x89tu");
  const Outcome cut = shop.run({"import", "cut.tumblestream", "-o", "x.tumble"});
  EXPECT_EQ(cut.exit, 2);
  EXPECT_NE(cut.err.find("is the beginning of a recorder's stream, cut to 3 bytes"), std::string::npos) << cut.err;
  EXPECT_LT(cut.err.size(), 200U) << cut.err;
  EXPECT_EQ(shop.run({"info", "x.tumble"}).exit, 2) << "no log must be there";
}

}  // namespace
}  // namespace tumble::test
