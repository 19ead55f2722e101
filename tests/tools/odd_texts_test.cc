// Texts with commas come back from a dump; two logs are bisected by what both have; words for what is odd.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/program.h"

namespace tumble::test {
namespace {

/// Two steps of one body with a channel of text, escaped in the table.
std::string table_of(const std::string& mode, const std::string& seed = "") {
  const std::string zeros = ",0,0,1,1,0,0,0,0,0,0,0,0,0,0,";
  const std::string rest = mode + (seed.empty() ? "" : ',' + seed) + '\n';
  return "# engine: toy\n# dt: 1\n# escapes: "
         "percent\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,"
         "orientation.y,orientation.z,velocity.x,velocity.y,velocity.z,spin.x,spin.y,spin.z,frozen,channel.mode" +
         std::string(seed.empty() ? "" : ",world.seed") + "\n0,1" + zeros + rest + "1,1" + zeros + rest;
}

void import_table(const Workshop& shop, const std::string& name, const std::string& table) {
  shop.write(name + ".csv", table);
  const Outcome run = shop.run({"import", name + ".csv"});
  ASSERT_EQ(run.exit, 0) << run.err;
}

TEST(OddTexts, OfADumpAreImportedAgain) {
  const Workshop shop;
  import_table(shop, "a", table_of("walk%2c run; 50%25 %0a"));
  const Outcome dump = shop.run({"dump", "a.tumble", "--steps", "0:1", "--csv"});
  ASSERT_EQ(dump.exit, 0) << dump.err;
  EXPECT_EQ(dump.out.find("# escapes: percent\nstep,id,"), 0U) << dump.out;
  EXPECT_NE(dump.out.find("walk%2c run; 50%25 %0a"), std::string::npos) << dump.out;
  import_table(shop, "b", "# engine: toy\n# dt: 1\n" + dump.out);
  EXPECT_EQ(shop.run({"diff", "a.tumble", "b.tumble"}).exit, 0);
  import_table(shop, "plain", table_of("7"));
  const Outcome plain = shop.run({"dump", "plain.tumble", "--steps", "0:1", "--csv"});
  EXPECT_EQ(plain.out.find("step,id,"), 0U) << "no text, no escapes: " << plain.out;
}

// A text of a pair with a blank, a name that ends as if with a unit, a unit with a comma.
TEST(OddTexts, OfPairsAndOddNamesComeBackFromADump) {
  const Workshop shop;
  const std::string zeros = ",0,0,1,1,0,0,0,0,0,0,0,0,0,0,";
  std::string table =
      "# engine: toy\n# dt: 1\n# escapes: "
      "percent\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,"
      "orientation.y,orientation.z,velocity.x,velocity.y,velocity.z,spin.x,spin.y,spin.z,frozen,pair.how,channel.load "
      "(left) (),channel.share (a%2c b)\n";
  for (const char* step : {"0", "1"}) {
    table += std::string(step) + ",1" + zeros + "2=a%2520b 3=%2525,0.5,0.25\n";
    table += std::string(step) + ",2" + zeros + "3=c,1.5,0.75\n";
    table += std::string(step) + ",3" + zeros + ",,\n";
  }
  import_table(shop, "a", table);
  const Outcome dump = shop.run({"dump", "a.tumble", "--steps", "0:1", "--csv"});
  ASSERT_EQ(dump.exit, 0) << dump.err;
  EXPECT_EQ(dump.err, "");
  import_table(shop, "b", "# engine: toy\n# dt: 1\n" + dump.out);
  const Outcome same = shop.run({"diff", "a.tumble", "b.tumble", "--json"});
  EXPECT_EQ(same.exit, 0) << dump.out << same.out;
  const auto channels_of = [&shop](const char* log) {
    return nlohmann::json::parse(shop.run({"info", log, "--json"}).out)["channels"];
  };
  EXPECT_EQ(channels_of("a.tumble"), channels_of("b.tumble"));
  EXPECT_EQ(channels_of("a.tumble")[0]["name"], "how");
}

TEST(OddTexts, SayWhatToDoWithABodyThatLeftTheWorld) {
  const Workshop shop;
  const auto failure_of = [&shop](const std::string& motion) {
    shop.write("far.toml",
               "title = \"far\"\ncategory = \"session\"\n[world]\nmethod = \"layered\"\ndt = 0.01\nsteps = 3\n"
               "gravity = [0.0, 0.0, 0.0]\n[[box]]\n" +
                   motion + "\n");
    const Outcome run = shop.run({"record", "far.toml", "-o", "far.tumble", "--quiet"});
    EXPECT_EQ(run.exit, 4) << run.out;
    return run.err;
  };
  const std::string left = failure_of("position = [32760.0, 0.0, 9.0]\nvelocity = [4000.0, 0.0, 0.0]");
  EXPECT_NE(left.find("body 1: found position (32800"), std::string::npos) << left;
  EXPECT_NE(left.find("it left the world: start nearer to the origin, stop it, or remove it before"), std::string::npos)
      << left;
  EXPECT_EQ(left.find("use smaller speeds"), std::string::npos) << "that is for what is too fast: " << left;
}

TEST(OddTexts, SayWhatATableOfPointsLacks) {
  const Workshop shop;
  shop.write("points.csv", "# engine: toy\n# dt: 1\nstep,id,position.x,position.y,position.z\n0,1,0,0,1\n1,1,0,0,1\n");
  const Outcome run = shop.run({"import", "points.csv"});
  EXPECT_EQ(run.exit, 2) << run.out;
  EXPECT_NE(run.err.find("orientation.w, … (where nothing turns, 1 in .w and 0 in the others)"), std::string::npos)
      << run.err;
}

TEST(OddTexts, GiveMicrosecondsToASessionOfThem) {
  const Workshop shop;
  std::string table = table_of("7");
  table.replace(table.find("# dt: 1\n"), 8, "# dt: 0.00001\n");
  import_table(shop, "short", table);
  const Outcome info = shop.run({"info", "short.tumble"});
  EXPECT_NE(info.out.find("10.0 µs"), std::string::npos) << info.out;
}

TEST(OddTexts, BisectJudgesWhatBothHaveWhereAsked) {
  const Workshop shop;
  import_table(shop, "a", table_of("walk", "7"));
  import_table(shop, "b", table_of("walk"));
  EXPECT_EQ(shop.run({"bisect", "a.tumble", "b.tumble"}).exit, 1);
  const Outcome shared = shop.run({"bisect", "a.tumble", "b.tumble", "--shared"});
  EXPECT_EQ(shared.exit, 0) << shared.out << shared.err;
  EXPECT_NE(shared.out.find("though only a.tumble has channel seed, as --shared allows"), std::string::npos)
      << shared.out;
}

}  // namespace
}  // namespace tumble::test
