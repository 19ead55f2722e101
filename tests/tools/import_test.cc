// Logs of other engines as a user meets them: import, what works with them, and what replay says.
#include <gtest/gtest.h>

#include <filesystem>
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

// Reading the first byte of that file fails, as reading any byte of a bad disk does: what was read is no whole file.
TEST(Import, AReadThatFailsIsNoEndOfAFile) {
  const char* const unreadable = "/proc/self/mem";
  if (!std::filesystem::exists(unreadable)) GTEST_SKIP() << "no such file in this system";
  const Workshop shop;
  shop.write("table.csv", "# dt: 0.1\nstep,id\n");
  for (const std::vector<std::string>& words : {std::vector<std::string>{"import", unreadable, "-o", "x.tumble"},
                                                {"import", "table.csv", "--map-file", unreadable, "-o", "x.tumble"}}) {
    const Outcome run = shop.run(words);
    EXPECT_EQ(run.exit, 4) << run.out;
    EXPECT_NE(run.err.find("/proc/self/mem: cannot be read"), std::string::npos) << run.err;
  }
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

// As mail and version control do with what they take for text.
TEST(Import, SaysThatAStreamWasCopiedAsText) {
  const Workshop shop;
  for (const char* start : {"\x89tumblestream\n\x1a", "\x89tumblestream\r\r\n\x1a", "\x09tumblestream\r\n\x1a",
                            "\xc2\x89tumblestream\r\n\x1a", "\xef\xbf\xbdtumblestream\r\n\x1a"}) {
    shop.write("a.tumblestream", start + std::string(40, 'x'));
    const Outcome text = shop.run({"import", "a.tumblestream", "-o", "x.tumble"});
    EXPECT_EQ(text.exit, 2);
    EXPECT_NE(text.err.find("is a recorder's stream that was copied as text"), std::string::npos) << text.err;
  }
}

TEST(Import, ReadsNamesOfChannelsThatDumpWrote) {
  const Workshop shop;
  shop.write("a.csv",
             "# dt: 0.01\n# escapes: percent\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,"
             "orientation.y,orientation.z,channel.z%2c1,channel.q "
             "(m%2cs)\n0,1,0,0,0,1,0,0,0,1.5,2\n1,1,0,0,0,1,0,0,0,1.5,2\n");
  ASSERT_EQ(shop.run({"import", "a.csv"}).exit, 0);
  const std::string table = shop.run({"dump", "a.tumble", "--steps", "0:1", "--csv"}).out;
  EXPECT_NE(table.find("frozen,channel.q (m%2cs),channel.z%2c1\n"), std::string::npos) << table;
  shop.write("b.csv", table);
  ASSERT_EQ(shop.run({"import", "b.csv", "--like", "a.tumble"}).exit, 0);
  EXPECT_EQ(shop.run({"diff", "a.tumble", "b.tumble"}).exit, 0);
  ASSERT_EQ(shop.run({"measure", "a.tumble", "--series", "s.csv"}).exit, 0);
  EXPECT_NE(shop.read("s.csv").find(",\"channel.z,1.min\",\"channel.z,1.max\""), std::string::npos);
}

}  // namespace
}  // namespace tumble::test
