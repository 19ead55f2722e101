// `tumble measure` as docs/commands.md describes it: its keys, its choice of bodies and steps, plots, mirrored pairs.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "replay/measure/metric_list.h"
#include "tests/support/program.h"
#include "tests/tools/json_output.h"

namespace tumble::test {
namespace {

using nlohmann::ordered_json;

TEST(Program, MeasureKeepsItsContract) {
  const Workshop shop;
  shop.record_small("s");
  const ordered_json json = parsed(shop.run({"measure", "s.tumble", "--json", "--series", "s.csv"}));
  using Keys = std::vector<std::string>;
  EXPECT_EQ(keys_of(json), (Keys{"schema", "log", "bodies", "steps", "symmetry", "energy", "stacking", "channels",
                                 "partings", "final_hash", "axes", "first_lost", "not_finite", "notes"}));
  std::map<std::string, Keys> wanted;
  for (const replay::MetricRow& metric : replay::metric_list()) wanted[metric.group].emplace_back(metric.name);
  for (const auto& [group, keys] : wanted) EXPECT_EQ(keys_of(json[group]), keys);
  EXPECT_EQ(json["bodies"], 3);
  EXPECT_EQ(json["steps"], 40);
  EXPECT_TRUE(json["symmetry"]["column_spread"].is_null());
  EXPECT_TRUE(json["stacking"]["lost"].is_number_unsigned()) << "a count, not 0.0";
  std::istringstream rows(shop.read("s.csv"));
  std::string line;
  std::size_t count = 0;
  while (std::getline(rows, line)) ++count;
  EXPECT_EQ(count, 42U) << "a header, state 0 and 40 steps";
}

TEST(Program, MeasuresSomeBodiesFromAStepOn) {
  const Workshop shop;
  shop.record_small("s");
  const ordered_json all = parsed(shop.run({"measure", "s.tumble", "--json"}));
  const ordered_json some = parsed(shop.run({"measure", "s.tumble", "--json", "--bodies", "2", "--from-step", "40"}));
  EXPECT_GT(all["stacking"]["top_drop_max"], 0.0);
  EXPECT_EQ(some["stacking"]["top_drop_max"], 0.0) << "nothing has moved since the last step";
  EXPECT_EQ(shop.run({"measure", "s.tumble", "--bodies", "77"}).exit, 2);
  EXPECT_EQ(shop.run({"measure", "s.tumble", "--from-step", "41"}).exit, 2);
  EXPECT_EQ(shop.run({"measure", "s.tumble", "--axis", "z"}).exit, 2);
}

TEST(Program, ABoundOverBodiesThatAreNotInTheStartHasNoValueToHoldFor) {
  const Workshop shop;
  shop.record_small("s");
  const ordered_json thrown =
      parsed(shop.run({"measure", "s.tumble", "--json", "--bodies", "input", "--series", "t.csv"}));
  EXPECT_GT(thrown["stacking"]["kinetic_end"], 0.0) << "the thrown body itself is there";
  EXPECT_EQ(thrown["stacking"]["frozen_fraction"], 0.0);
  for (const char* bound : {"lateral_max<=0", "lateral_rms<=0", "drift_max<=0", "tilt_max<=0", "top_drop_max<=0"}) {
    const Outcome outcome = shop.run({"measure", "s.tumble", "--bodies", "input", "--require", bound});
    EXPECT_EQ(outcome.exit, 1) << bound;
    EXPECT_NE(outcome.err.find("found no value: no body of the start is left at the end"), std::string::npos)
        << outcome.err;
    const std::string name(bound, std::string_view(bound).find('<'));
    EXPECT_TRUE(thrown[name.starts_with("lateral") ? "symmetry" : "stacking"][name].is_null()) << name;
  }
  const std::string rows = shop.read("t.csv");
  EXPECT_NE(rows.find(",,,,,,0,"), std::string::npos) << "lateral_max to top_drop_max are empty\n" << rows;
}

TEST(Program, AMetricAtTheEndHasNoValueOnceItsBodiesAreRemoved) {
  const Workshop shop;
  shop.write("r.toml",
             "[world]\nsteps = 20\n[[box]]\nposition = [0.0, 0.0, 0.5]\n[[box]]\nposition = [4.0, 0.0, 3.0]\n"
             "[[input]]\nstep = 9\nkind = \"remove\"\nid = 2\n");
  ASSERT_EQ(shop.run({"record", "r.toml", "-o", "r.tumble", "--quiet"}).exit, 0);
  const ordered_json gone = parsed(shop.run({"measure", "r.tumble", "--json", "--bodies", "2"}))["stacking"];
  for (const char* name :
       {"drift_max", "tilt_max", "top_drop_max", "overlap_max", "ground_penetration_max", "kinetic_end",
        "kinetic_linear_end", "kinetic_rotational_end", "frozen_fraction", "rest_time"}) {
    EXPECT_TRUE(gone[name].is_null()) << name << ' ' << gone[name];
  }
  EXPECT_EQ(gone["lost"], 0);
  EXPECT_EQ(shop.run({"measure", "r.tumble", "--require", "top_drop_max<=0.01"}).exit, 0) << "body 1 is left";
  const Outcome outcome = shop.run({"measure", "r.tumble", "--bodies", "2", "--require", "kinetic_end<=0"});
  EXPECT_EQ(outcome.exit, 1);
  EXPECT_NE(outcome.err.find("found no value: no body at the end"), std::string::npos) << outcome.err;
}

// A list with a slip of the pen would judge fewer bodies, and hold.
TEST(Program, ABodyThatTheSessionNeverHasIsNamed) {
  const Workshop shop;
  shop.record_small("s");
  for (const auto& [list, missing] :
       {std::pair("1,7777", "body 7777"), {"1,500-600", "bodies 500-600"}, {"1,tower:3", "tower:3"}}) {
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"measure", "s.tumble", "--bodies", list},
          {"export", "s.tumble", "-o", "e.csv", "--bodies", list},
          {"measure", "s.tumble", "--bodies", list, "--require", "lost<=0"}}) {
      const Outcome outcome = shop.run(command);
      EXPECT_EQ(outcome.exit, 2) << outcome.out;
      EXPECT_NE(outcome.err.find(std::string("found no ") + missing), std::string::npos) << outcome.err;
    }
  }
  EXPECT_TRUE(shop.names_with("e.csv").empty());
  EXPECT_EQ(shop.run({"measure", "s.tumble", "--bodies", "1,input"}).exit, 0) << "thrown in later";
}

TEST(Program, MeasureDrawsPlots) {
  const Workshop shop;
  shop.record_small("s");
  ASSERT_EQ(shop.run({"measure", "s.tumble", "--plot", "it's 1.svg"}).exit, 0);
  const std::string svg = shop.read("it's 1.svg");
  EXPECT_TRUE(svg.starts_with("<?xml")) << svg.substr(0, 80);
  for (const char* label : {"three boxes", "kinetic", "highest", "deepest overlap"}) {
    EXPECT_NE(svg.find(label), std::string::npos) << label;
  }
  ASSERT_EQ(shop.run({"measure", "s.tumble", "--plot", "s.png"}).exit, 0);
  EXPECT_EQ(shop.read("s.png").substr(1, 3), "PNG");
  EXPECT_EQ(shop.run({"measure", "s.tumble", "--plot", "s.gif"}).exit, 2);
  const Outcome nowhere = shop.run({"measure", "s.tumble", "--plot", "no/such/folder.svg"});
  EXPECT_EQ(nowhere.exit, 2);
  EXPECT_NE(nowhere.err.find("no/such/folder.svg: cannot be written: No such file"), std::string::npos) << nowhere.err;
}

TEST(Program, ATwinIsRecordedAndMeasured) {
  const Workshop shop;
  shop.record_small("a");
  shop.record_small("b", {"--mirror", "x", "--permute", "3", "--shift", "16,-0.5"});
  const ordered_json json = parsed(shop.run({"measure", "a.tumble", "--with", "b.tumble", "--json"}));
  for (const char* key : {"mirror_error", "order_error", "shift_error"}) EXPECT_EQ(json["symmetry"][key], 0.0) << key;
  EXPECT_NE(shop.run({"info", "b.tumble"}).out.find("mirror x, shift 16,-0.5, permute 3"), std::string::npos);
  EXPECT_EQ(shop.run({"diff", "a.tumble", "b.tumble"}).exit, 1) << "they are not the same session";
  shop.record_small("c", {"--mirror", "x", "--steps", "39"});
  EXPECT_EQ(shop.run({"measure", "a.tumble", "--with", "c.tumble"}).exit, 2);
  for (const char* bad : {"--mirror=z", "--shift=0.1,0", "--shift=1"}) {
    EXPECT_EQ(shop.run({"record", "s.toml", bad}).exit, 2) << bad;
  }
}

TEST(Program, MeasureNamesTheFirstLostBody) {
  const Workshop shop;
  std::string table =
      "# engine: e\n# dt: 0.01\n# up: y\n# length: cm\n"
      "step,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z\n";
  for (int k = 0; k < 12; ++k) {
    const std::string row = std::to_string(k) + (k < 7 ? ",crate,50" : ",crate,5e8") + ",50,0,1,0,0,0\n";
    table += row + std::to_string(k) + ",still,300,50,0,1,0,0,0\n";
  }
  shop.write("t.csv", table);
  ASSERT_EQ(shop.run({"import", "t.csv"}).exit, 0);
  const std::string text = shop.run({"measure", "t.tumble"}).out;
  EXPECT_NE(text.find("body crate in step 7, at 5e+08 50 0 cm"), std::string::npos) << text;
  const ordered_json json = parsed(shop.run({"measure", "t.tumble", "--json"}));
  EXPECT_EQ(json["first_lost"]["step"], 7);
  EXPECT_EQ(json["first_lost"]["position"], (ordered_json{5e8, 50.0, 0.0}));
  shop.record_small("s");
  EXPECT_TRUE(parsed(shop.run({"measure", "s.tumble", "--json"}))["first_lost"].is_null());
}

}  // namespace
}  // namespace tumble::test
