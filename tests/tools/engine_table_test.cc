// Imported tables as their owner meets them again: in the axes and units of the table, with the bodies named that are
// lost because a number is none, and with every oddness of the table told.
#include "tests/tools/engine_table.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/program.h"
#include "tests/tools/json_output.h"

namespace tumble::test {
namespace {

using nlohmann::ordered_json;

TEST(EngineTable, NumbersThatJsonLacksReadBackToTheSameBits) {
  const Workshop shop;
  const std::vector<std::pair<std::string, std::string>> cells = {
      {"nan", "nan(0x7ff8000000000000)"},
      {"-inf", "-inf(0xfff0000000000000)"},
      {"nan(0x7ff800000000beef)", "nan(0x7ff800000000beef)"},
      {"nan(0xfff8000000000001)", "nan(0xfff8000000000001)"},
      {"nan(0x7ff0000000000001)", "nan(0x7ff0000000000001)"}};
  for (const auto& [cell, text] : cells) {
    ASSERT_EQ(import(shop, table(cell)).exit, 0) << cell;
    const ordered_json step = parsed(shop.run({"dump", "t.tumble", "--step", "2", "--json"}));
    EXPECT_EQ(step["bodies"][1]["spin"][0], text);
    const std::string again = shop.run({"dump", "t.tumble", "--steps", "0:4", "--csv"}).out;
    EXPECT_TRUE(says(again, "," + cell + ",0")) << again;
    shop.write("again.csv", "# engine: toy\n# dt: 0.1\n" + again);
    ASSERT_EQ(shop.run({"import", "again.csv"}).exit, 0);
    EXPECT_EQ(parsed(shop.run({"info", "again.tumble", "--json"}))["final_hash"],
              parsed(shop.run({"info", "t.tumble", "--json"}))["final_hash"]);
    EXPECT_EQ(parsed(shop.run({"dump", "again.tumble", "--step", "2", "--json"}))["bodies"], step["bodies"]);
  }
}

// Steps of several lengths, up y, floats: none of it stands in the columns of a state.
TEST(EngineTable, ADumpReadsBackWithItsTimesAxesAndPrecision) {
  const Workshop shop;
  std::string columns = kTableColumns;
  columns.insert(columns.size() - 1, ",dt");
  std::string text = "# engine: toy\n# up: y\n# precision: float32\n" + columns;
  for (int k = 0; k < 5; ++k) {
    const std::string dt = k == 2 ? "0.02" : "0.015625";
    text += std::to_string(k) + ",1,0.1,0." + std::to_string(9 - k) + ",0,1,0,0,0,0,-1,0,0,0,0,0," + dt + "\n";
  }
  ASSERT_EQ(import(shop, text).exit, 0);
  const Outcome dump = shop.run({"dump", "t.tumble", "--steps", "0:4", "--csv"});
  ASSERT_EQ(dump.exit, 0) << dump.err;
  EXPECT_TRUE(dump.out.starts_with("# up: y\n# precision: float32\n")) << dump.out;
  shop.write("again.csv", dump.out);
  for (const std::vector<std::string>& like : {std::vector<std::string>{}, {"--like", "t.tumble"}}) {
    std::vector<std::string> arguments = {"import", "again.csv", "-o", "again.tumble"};
    arguments.insert(arguments.end(), like.begin(), like.end());
    const Outcome again = shop.run(arguments);
    ASSERT_EQ(again.exit, 0) << again.err;
    const Outcome diff = shop.run({"diff", "t.tumble", "again.tumble"});
    EXPECT_EQ(diff.exit, 0) << diff.out << diff.err;
    const ordered_json info = parsed(shop.run({"info", "again.tumble", "--json"}));
    EXPECT_EQ(info["seconds"], 3 * 0.015625 + 0.02);
    EXPECT_EQ(info["dt_min"], 0.015625);
    EXPECT_EQ(info["dt_max"], 0.02);
    EXPECT_EQ(info["axes"]["up"], "y");
    EXPECT_EQ(info["engine"]["precision_bits"], 24);
  }
  EXPECT_TRUE(says(shop.run({"info", "again.tumble"}).out, "0.015625 to 0.02 s, varies"));
}

TEST(EngineTable, ATableWithoutTimesTakesNoneOfASessionWhoseStepsDiffer) {
  const Workshop shop;
  std::string rows;
  for (const char* cells : {"0,0", "1,0.25", "2,0.75"}) {
    rows += std::string(cells).substr(0, 1) + ",1,0,0,0.5,1,0,0,0,0,0,0,0,0,0,0" + (cells + 1) + "\n";
  }
  std::string timed = kTableColumns;
  timed.insert(timed.size() - 1, ",time");
  ASSERT_EQ(import(shop, timed + rows).exit, 0);
  shop.write("plain.csv", std::string(kTableColumns) + "0,1,0,0,0.5,1,0,0,0,0,0,0,0,0,0,0\n");
  const Outcome plain = shop.run({"import", "plain.csv", "--like", "t.tumble"});
  EXPECT_EQ(plain.exit, 2);
  EXPECT_TRUE(says(plain.err, "the steps of the session to be like differ in length")) << plain.err;
}

TEST(EngineTable, ACaseThatEndsEarlyOrLacksABodyFailsThoughItsBoundsHold) {
  const Workshop shop;
  shop.write("s/cases/one/scene.toml", kSmallScene);
  shop.write("s/cases/one/metrics.toml",
             std::string("require = [\"behaviour\"]\n[command]\nrun = \"") + TUMBLE_PROGRAM +
                 " import ../t.csv -o {log} # {scene}\"\n[[metric]]\nname = \"lateral_max\"\n"
                 "max = 1.0\nwhy = \"they stay\"\n");
  const std::string whole = table();
  shop.write("t.csv", whole);
  ASSERT_EQ(shop.run({"bless", "one", "--suite", "s", "--reason", "a test"}).exit, 0);
  shop.write("t.csv", whole.substr(0, whole.find("\n4,") + 1));
  const Outcome early = shop.run({"check", "--suite", "s", "--report", "r"});
  EXPECT_EQ(early.exit, 1);
  EXPECT_TRUE(says(early.out, "its session has 3 steps, its golden 4")) << early.out;
  std::string alone = whole;
  for (std::size_t at = 0; (at = alone.find(",2,3,0,")) != std::string::npos;) {
    const std::size_t line = alone.rfind('\n', at) + 1;
    alone.erase(line, alone.find('\n', at) + 1 - line);
  }
  shop.write("t.csv", alone);
  const Outcome fewer = shop.run({"check", "--suite", "s", "--report", "r"});
  EXPECT_EQ(fewer.exit, 1);
  EXPECT_TRUE(says(fewer.out, "starts with other bodies: 1, its golden with 2")) << fewer.out;
  ASSERT_EQ(shop.run({"bless", "one", "--suite", "s", "--reason", "one body is meant"}).exit, 0);
  EXPECT_EQ(shop.run({"check", "--suite", "s", "--report", "r"}).exit, 0);
}

TEST(EngineTable, ResultsComeBackInItsAxesAndUnit) {
  const Workshop shop;
  const std::string rows =
      "0,4,10,50,-30,0.2,0.2,0.4,0.8717797887081347,1,2,-0,4,5,-6,0\n"
      "1,4,12,51,-37,0.2,0.2,0.4,0.8717797887081347,1,2,-0,4,5,-6,0\n";
  for (const char* handed : {"right", "left"}) {
    const Outcome imported =
        import(shop, std::string("# dt: 0.1\n# up: y\n# length: cm\n# handed: ") + handed + "\n" + kTableColumns + rows,
               {"--json"});
    ASSERT_EQ(imported.exit, 0) << imported.err;
    EXPECT_EQ(parsed(imported)["axes"]["up"], "y");
    EXPECT_EQ(parsed(imported)["axes"]["length"], "cm");
    EXPECT_EQ(parsed(imported)["axes"]["handed"], handed);
    EXPECT_TRUE(shop.run({"dump", "t.tumble", "--steps", "0:1", "--csv"}).out.ends_with(kTableColumns + rows))
        << handed;
    const ordered_json step = parsed(shop.run({"dump", "t.tumble", "--step", "1", "--json"}));
    EXPECT_EQ(step["axes"]["up"], "y");
    EXPECT_EQ(step["bodies"][0]["position"], ordered_json::parse("[12.0, 51.0, -37.0]"));
    EXPECT_TRUE(says(shop.run({"dump", "t.tumble", "--step", "1"}).out, "y cm"));
    const ordered_json along_z = parsed(shop.run({"measure", "t.tumble", "--axis", "z", "--json"}));
    EXPECT_EQ(along_z["axes"], step["axes"]);
    EXPECT_NEAR(along_z["symmetry"]["lateral_max"].get<double>(), 7, 1e-12);
    const ordered_json along_x = parsed(shop.run({"measure", "t.tumble", "--axis", "x", "--json"}));
    EXPECT_NEAR(along_x["symmetry"]["lateral_max"].get<double>(), 2, 1e-12);
    EXPECT_NEAR(along_x["stacking"]["top_drop_max"].get<double>(), 0, 1e-12) << "it rose by 1 cm along y";
    const Outcome up = shop.run({"measure", "t.tumble", "--axis", "y"});
    EXPECT_EQ(up.exit, 2);
    EXPECT_TRUE(says(up.err, "wanted x or z; y points up")) << up.err;
    EXPECT_TRUE(says(shop.run({"measure", "t.tumble"}).out, "2 cm"));
    EXPECT_EQ(shop.run({"measure", "t.tumble", "--require", "lateral_max<=2.001"}).exit, 0);
    const Outcome beyond = shop.run({"measure", "t.tumble", "--require", "lateral_max<=1.9"});
    EXPECT_EQ(beyond.exit, 1);
    EXPECT_TRUE(says(beyond.err, " cm")) << beyond.err;
  }
}

TEST(EngineTable, DiffNamesFieldsByItsAxes) {
  const Workshop shop;
  const std::string start = std::string("# dt: 0.1\n# up: y\n") + kTableColumns + "0,4,1,2,3,1,0,0,0,0,0,0,0,0,0,0\n";
  shop.write("a.csv", start + "1,4,1,2,3,1,0,0,0,0,0,0,0,0,0,0\n");
  shop.write("b.csv", start + "1,4,1,2,3.5,1,0,0,0,0,0,0,0,0,0,0\n");
  for (const char* name : {"a.csv", "b.csv"}) ASSERT_EQ(shop.run({"import", name}).exit, 0);
  const Outcome outcome = shop.run({"diff", "a.tumble", "b.tumble", "--json"});
  EXPECT_EQ(outcome.exit, 1);
  const ordered_json first = parsed(outcome)["first"];
  EXPECT_EQ(first["field"], "position.z") << "our y points along its -z";
  EXPECT_TRUE(says(parsed(outcome)["cause"], "body 4 position.z: 3 → 3.5")) << "the sentence names it likewise";
  EXPECT_EQ(first["expected"], 3.0);
  EXPECT_EQ(first["actual"], 3.5);
  EXPECT_TRUE(says(shop.run({"diff", "a.tumble", "b.tumble"}).out, "y up, right-handed, m"));
  const ordered_json field =
      parsed(shop.run({"diff", "a.tumble", "b.tumble", "--step", "1", "--json"}))["bodies"][0]["fields"][0];
  EXPECT_EQ(field["field"], "position.z");
  EXPECT_EQ(field["b"], 3.5);
}

TEST(EngineTable, NumbersOfErrorsAreTheOnesOfTheTable) {
  const Workshop shop;
  const auto error = [&](const std::string& columns, const std::string& cells) {
    shop.write("b.csv", "# dt: 0.1\n" + columns + "," + kTableColumns + cells + ",0,1,0,0,1,1,0,0,0,0,0,0,0,0,0,0\n");
    return shop.run({"import", "b.csv"}).err;
  };
  EXPECT_TRUE(says(error("mass", "4.9e-324"), "found a mass of 5e-324 kg, wanted 1e-09 … 1e+12 kg"));
  EXPECT_TRUE(says(error("size.x,size.y,size.z", "1,1e308,1"), "found an edge of 1e+308 m, wanted 0.0001 … 4096 m"));
  EXPECT_TRUE(says(error("size.x,size.y,size.z", "1,1,-inf"), "size.z: found -inf, wanted an edge above 0"));
}

TEST(EngineTable, AFileThatIsNoTextIsAnErrorAtItsFirstByte) {
  const Workshop shop;
  const Outcome endless = shop.run({"import", "/dev/zero"});
  EXPECT_EQ(endless.exit, 2);
  EXPECT_TRUE(says(endless.err, "/dev/zero: found a byte 0 at 0, wanted a table as text")) << endless.err;
  std::string text = table();
  text[100] = '\0';
  EXPECT_TRUE(says(import(shop, text).err, "t.csv: found a byte 0 at 100"));
}

TEST(EngineTable, DiffOfALostBodyGivesItsBitsAndDrawsTheRest) {
  const Workshop shop;
  ASSERT_EQ(import(shop, table()).exit, 0);
  ASSERT_EQ(shop.run({"import", "t.csv", "-o", "whole.tumble"}).exit, 0);
  ASSERT_EQ(import(shop, table("nan")).exit, 0);
  EXPECT_EQ(shop.run({"diff", "t.tumble", "t.tumble", "--step", "2"}).exit, 0) << "the same bits, NaN or not";
  const Outcome step = shop.run({"diff", "whole.tumble", "t.tumble", "--step", "2", "--json"});
  EXPECT_EQ(step.exit, 1);
  EXPECT_EQ(parsed(step)["bodies"][0]["fields"][0]["b"], "nan(0x7ff8000000000000)");
  const Outcome drawn = shop.run({"diff", "whole.tumble", "t.tumble", "--plot", "gap.svg"});
  EXPECT_EQ(drawn.exit, 1) << drawn.err;
}

TEST(EngineTable, ACutTableIsFoundAsFarAsItCanBe) {
  const Workshop shop;
  const std::string whole = table();
  for (std::size_t cut = 1; cut < 50; ++cut) {  // anywhere in the last row
    const Outcome outcome = import(shop, whole.substr(0, whole.size() - cut));
    if (whole[whole.size() - cut - 1] == '\n') {
      EXPECT_EQ(outcome.exit, 0) << outcome.err;
      EXPECT_TRUE(says(outcome.err, "the last step has 1 of the 2 bodies of the step before")) << outcome.err;
    } else {
      EXPECT_EQ(outcome.exit, 2) << cut;
      EXPECT_TRUE(says(outcome.err, "the table may have been cut here")) << outcome.err;
    }
  }
  EXPECT_EQ(import(shop, whole).err, "");
}

TEST(EngineTable, RepeatedKeysAndOrientationsThatAreNoneAreErrors) {
  const Workshop shop;
  const Outcome twice = import(shop, "# dt: 0.1\n" + table());
  EXPECT_EQ(twice.exit, 2);
  EXPECT_TRUE(says(twice.err, "t.csv:3:1: dt: found a second time, first in line 1")) << twice.err;
  EXPECT_EQ(import(shop, table(), {"--header", "up: z", "--header", "up: y"}).exit, 2);
  EXPECT_EQ(import(shop, table(), {"--header", "dt: 0.2"}).exit, 0) << "the command line wins over the table";
  for (const std::size_t line : {std::size_t{0}, std::size_t{3}}) {
    for (const char* wrong : {"2,0,0,0", "0,0,0,0", "0.9,0.1,0,0"}) {
      std::string text = table();
      const std::string row = "\n" + std::to_string(line) + ",1,0,0,0.5,";
      text.replace(text.find(row) + row.size(), 7, wrong);
      const Outcome outcome = import(shop, text);
      EXPECT_EQ(outcome.exit, 2) << wrong;
      EXPECT_TRUE(says(outcome.err, "orientation: found a quaternion of length")) << outcome.err;
    }
  }
}

TEST(EngineTable, ARoughOrientationIsAWarningWithItsPlace) {
  const Workshop shop;
  std::string text = table();
  const std::string row = "\n3,1,0,0,0.5,";
  text.replace(text.find(row) + row.size(), 1, "1.001");
  const Outcome outcome = import(shop, text, {"--json"});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_TRUE(
      says(outcome.err, "warning: t.csv:10:13: body 1, step 3: the orientation is a quaternion of length 1.001"))
      << outcome.err;
  EXPECT_EQ(parsed(outcome)["warnings"].size(), 1U);
}

TEST(EngineTable, ColumnsPassedOverAreNamed) {
  const Workshop shop;
  std::string text = table();
  text.replace(text.find("frozen\n"), 6, "_sleep");
  const Outcome outcome = import(shop, text);
  EXPECT_TRUE(says(outcome.out, "columns _sleep")) << outcome.out;
  EXPECT_TRUE(says(shop.run({"info", "t.tumble"}).out, "columns _sleep of the table"));
  EXPECT_EQ(parsed(shop.run({"info", "t.tumble", "--json"}))["passed_over"], ordered_json::parse(R"(["_sleep"])"));
}

}  // namespace
}  // namespace tumble::test
