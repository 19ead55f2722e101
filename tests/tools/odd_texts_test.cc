// Texts with commas come back from a dump; two logs are bisected by what both have.
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
