// A body with a number that is none is lost: every command names body, step and field, by the axes of its table.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "tests/support/program.h"
#include "tests/tools/engine_table.h"
#include "tests/tools/json_output.h"

namespace tumble::test {
namespace {

using nlohmann::ordered_json;

TEST(LostBody, ABodyWithoutANumberIsLostInEveryCommand) {
  const Workshop shop;
  const Outcome imported = import(shop, table("nan"));
  ASSERT_EQ(imported.exit, 0) << imported.err;
  EXPECT_TRUE(says(imported.err, "t.csv:9:27: body 2 is lost from step 2 on: spin.x is nan")) << imported.err;
  const Outcome measured = shop.run({"measure", "t.tumble", "--json"});
  EXPECT_EQ(measured.exit, 0);
  EXPECT_TRUE(says(measured.err, "body 2 is lost from step 2 on: spin.x is nan")) << measured.err;
  const ordered_json json = parsed(measured);
  EXPECT_EQ(json["stacking"]["lost"], 1);
  EXPECT_TRUE(says(json["stacking"]["drift_max"].get<std::string>(), "nan(0x"));
  EXPECT_EQ(json["not_finite"]["body"], 2);
  EXPECT_EQ(json["not_finite"]["step"], 2);
  EXPECT_EQ(json["not_finite"]["field"], "spin.x");
  EXPECT_TRUE(says(shop.run({"measure", "t.tumble"}).out, "not a number"));
  for (const char* bound : {"lost<=0", "lost<=9", "drift_max<=0", "drift_max>0", "gain_ratio<=1e9", "lateral_max<=0",
                            "bounces<1e9", "tilt_max<=179", "frozen_fraction<=0.9", "kinetic_end>0"}) {
    const Outcome judged = shop.run({"measure", "t.tumble", "--require", bound});
    EXPECT_EQ(judged.exit, 1) << bound;
    EXPECT_TRUE(says(judged.err, std::string(bound) + ": found no number: body 2 is lost from step 2 on"))
        << judged.err;
  }
  EXPECT_EQ(shop.run({"measure", "t.tumble", "--bodies", "1", "--require", "drift_max<=0"}).exit, 0);
  EXPECT_EQ(shop.run({"measure", "t.tumble", "--bodies", "1", "--require", "gain_max<=9"}).exit, 1);
}

TEST(LostBody, ACaseWithALostBodyFailsAndCannotBeBlessed) {
  const Workshop shop;
  shop.write("s/cases/one/scene.toml", kSmallScene);
  shop.write("s/cases/one/metrics.toml", std::string("require = [\"behaviour\"]\n[command]\nrun = \"") +
                                             TUMBLE_PROGRAM +
                                             " import ../t.csv -o {log} # {scene}\"\n[[metric]]\nname = \"drift_max\"\n"
                                             "max = 1.0\nwhy = \"they stay\"\n");
  shop.write("t.csv", table());
  ASSERT_EQ(shop.run({"bless", "one", "--suite", "s", "--reason", "a test"}).exit, 0);
  EXPECT_EQ(shop.run({"check", "--suite", "s", "--report", "r"}).exit, 0);
  shop.write("t.csv", table("nan"));
  const Outcome checked = shop.run({"check", "--suite", "s", "--report", "r"});
  EXPECT_EQ(checked.exit, 1);
  const char* lost = "body 2 is lost from step 2 on: spin.x is nan";
  EXPECT_TRUE(says(checked.out, lost)) << checked.out;
  EXPECT_TRUE(says(shop.read("r/index.html"), lost));
  EXPECT_TRUE(says(shop.read("r/report.json"), lost));
  const Outcome blessed = shop.run({"bless", "one", "--suite", "s", "--reason", "a test"});
  EXPECT_EQ(blessed.exit, 2);
  EXPECT_TRUE(says(blessed.err, lost)) << blessed.err;
}

TEST(LostBody, ALostBodyIsNamedByItsAxesInEveryCommand) {
  const Workshop shop;
  const std::string start = std::string("# engine: toy\n# dt: 0.1\n# up: y\n") + kTableColumns;
  const std::string rest = ",1,0,0,0,0,0,0,0,0,0,0\n";
  const std::string whole = start + "0,1,0,1,2" + rest + "1,1,0,1,2" + rest;
  const std::string lost = start + "0,1,0,1,2" + rest + "1,1,0,-inf,2" + rest;
  shop.write("whole.csv", whole);
  ASSERT_EQ(shop.run({"import", "whole.csv"}).exit, 0);
  const char* told = "position.y is -inf";
  EXPECT_TRUE(says(import(shop, lost).err, told));
  const std::string lost_z = start + "0,1,0,1,2" + rest + "1,1,0,1,inf" + rest;
  shop.write("z.csv", lost_z);
  EXPECT_TRUE(says(shop.run({"import", "z.csv"}).err, "position.z is inf"));
  for (const auto& [log, words] : {std::pair{"t.tumble", told}, std::pair{"z.tumble", "position.z is inf"}}) {
    const Outcome measured = shop.run({"measure", log});
    EXPECT_TRUE(says(measured.out, words)) << measured.out;
    EXPECT_TRUE(says(measured.err, words)) << measured.err;
    EXPECT_TRUE(says(shop.run({"measure", log, "--require", "lost<=0"}).err, words));
    const ordered_json json = parsed(shop.run({"measure", log, "--json"}))["not_finite"];
    const std::string wanted = words;
    EXPECT_EQ(json["field"], wanted.substr(0, 10));
    EXPECT_TRUE(json["value"].get<std::string>().starts_with(wanted.substr(14))) << json;
    const Outcome compared = shop.run({"diff", "whole.tumble", log, "--json"});
    EXPECT_EQ(compared.exit, 1);
    EXPECT_EQ(parsed(compared)["aftermath"]["lost"]["field"], wanted.substr(0, 10));
    const Outcome text = shop.run({"diff", "whole.tumble", log});
    EXPECT_TRUE(says(text.out, wanted.substr(0, 10) + " is no finite number")) << text.out;
    EXPECT_TRUE(says(text.out, ", one is not a number\n") || says(text.out, ", infinitely far apart\n")) << text.out;
    EXPECT_TRUE(says(text.out, "where a body is lost: lateral_max, lateral_rms, ")) << text.out;
    EXPECT_FALSE(says(text.out, " nan")) << "a count of lost bodies that is none\n" << text.out;
    EXPECT_TRUE(says(shop.run({"diff", log, log}).out, words)) << "a note on each log";
    const Outcome drawn = shop.run({"render", log, "--step", "1", "-o", "t.png", "--size", "64x64"});
    EXPECT_TRUE(says(drawn.err, "its " + wanted)) << drawn.err;
  }
}

TEST(LostBody, ACaseNamesTheFieldOfALostBodyByItsTable) {
  const Workshop shop;
  shop.write("s/cases/one/scene.toml", kSmallScene);
  shop.write("s/cases/one/metrics.toml", std::string("require = [\"behaviour\"]\n[command]\nrun = \"") +
                                             TUMBLE_PROGRAM +
                                             " import ../t.csv --header 'up: y' -o {log} # {scene}\"\n[[metric]]\nname"
                                             " = \"drift_max\"\nmax = 1.0\nwhy = \"they stay\"\n");
  std::string text = table();
  text.replace(text.find("\n3,1,0,0,0.5,") + 9, 3, "nan");
  shop.write("t.csv", text);
  const Outcome checked = shop.run({"check", "--suite", "s", "--report", "r"});
  EXPECT_EQ(checked.exit, 1);
  const char* lost = "body 1 is lost from step 3 on: position.z is nan";
  EXPECT_TRUE(says(checked.out, lost)) << checked.out;
  EXPECT_TRUE(says(shop.read("r/index.html"), lost));
  EXPECT_TRUE(says(shop.read("r/report.json"), lost));
  EXPECT_TRUE(says(shop.read("r/junit.xml"), lost));
}

}  // namespace
}  // namespace tumble::test
