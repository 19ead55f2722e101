// The benchmarks give figures of what they say they measure, and say what they left out.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "tests/support/program.h"

namespace tumble::test {
namespace {

using Json = nlohmann::json;

Json bench(const Workshop& shop, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "bench");
  arguments.emplace_back("--json");
  const Outcome outcome = shop.run(arguments);
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  return Json::parse(outcome.out, nullptr, false);
}

TEST(Bench, OursIsExactInAnyOrderOfAdding) {
  const Workshop shop;
  const Json results = bench(shop, {"peers", "--scene", "grid_6_coarse", "--repeat", "2", "--engine", "none"});
  ASSERT_EQ(results["scenes"].size(), 1U);
  const Json ours = results["scenes"][0]["engines"][0];
  EXPECT_EQ(results["scenes"][0]["bodies"], 36);
  EXPECT_TRUE(ours["engine"].get<std::string>().starts_with("Tumble")) << ours;
  EXPECT_EQ(ours["failure"], "");
  EXPECT_EQ(ours["cpu_s_runs"].size(), 2U);
  EXPECT_GT(ours["cpu_s"], 0);
  EXPECT_EQ(ours["lateral_max"], 0);
  EXPECT_EQ(ours["column_spread"], 0);
  EXPECT_EQ(ours["order_error"], 0);
  EXPECT_EQ(ours["lost"], 0);
}

/// The thesis's label of a cell's substeps is the depth of a recursion that halves: 10, 40 and 200 allow 8, 32 and 128.
std::uint64_t halved_to(std::uint64_t label) {
  std::uint64_t most = 1;
  while (2 * most <= label) most *= 2;
  return most;
}

TEST(Bench, TableOneRunsWhatTheBudgetAllowsAndEstimatesNothing) {
  const Workshop shop;
  const Json results = bench(shop, {"table1", "--budget", "0.5", "--save", "table1.json"});
  ASSERT_EQ(results["cells"].size(), 70U);
  std::size_t run = 0, as_labelled = 0;
  for (const Json& cell : results["cells"]) {
    EXPECT_EQ(cell["substeps_most"], halved_to(cell["substeps"])) << cell;
    if (cell["cpu_s"].is_null()) {
      EXPECT_TRUE(cell["ratio"].is_null() && cell["substeps_mean"].is_null() && cell["lateral_max"].is_null()) << cell;
      continue;
    }
    ++run;
    if (cell["substeps_most"] == cell["substeps"]) ++as_labelled;
    EXPECT_NEAR(cell["ratio"].get<double>() * cell["cpu_s"].get<double>(), cell["thesis_s"].get<double>(), 1e-6);
    EXPECT_GE(cell["substeps_mean"], 1) << cell;
    EXPECT_LE(cell["substeps_mean"], cell["substeps_largest"]) << cell;
    EXPECT_LE(cell["substeps_largest"], cell["substeps_most"]) << cell;
    EXPECT_EQ(cell["lateral_max"], 0) << cell;
    EXPECT_EQ(cell["lost"], 0) << cell;
  }
  EXPECT_EQ(results["cells_run"], run);
  EXPECT_GT(run, 0U);
  EXPECT_LT(run, 70U);
  EXPECT_EQ(results["thesis_ratio"]["cells"], run);
  EXPECT_EQ(results["thesis_ratio_as_labelled"]["cells"], as_labelled);
  EXPECT_EQ(Json::parse(shop.read("table1.json"))["cells"], results["cells"]);
  EXPECT_FALSE(results["machine"]["flags"].get<std::string>().empty());
}

TEST(Bench, TableOneGivesAnEngineTheSubstepsThatOursTook) {
  const Workshop shop;
  const Json results = bench(shop, {"table1", "--budget", "0.1", "--engine", "layered"});
  std::size_t both = 0;
  for (const Json& cell : results["cells"]) {
    const Json& engine = cell["engines"].at(0);
    if (engine["cpu_s"].is_null()) continue;
    ++both;
    EXPECT_EQ(engine["substeps"], std::lround(cell["substeps_mean"].get<double>())) << cell;
  }
  EXPECT_GT(both, 2U);
  EXPECT_EQ(results["engine_ratios"][0]["cells"], both);
  EXPECT_TRUE(results["engine_ratios"][0]["engine"].get<std::string>().ends_with("layered"));
}

TEST(Bench, AccuracyIsTheDistanceFromTheFinestRun) {
  const Workshop shop;
  const Json results = bench(shop, {"accuracy", "--scene", "grid_3", "--engine", "thesis", "--engine", "layered"});
  ASSERT_EQ(results["engines"].size(), 2U);
  ASSERT_EQ(results["limits"].size(), 1U);
  for (const Json& engine : results["engines"]) {
    const Json& runs = engine["runs"];
    ASSERT_EQ(runs.size(), 12U);
    EXPECT_EQ(runs[0]["from_limit"], 0);
    for (const Json& run : runs) {
      EXPECT_EQ(run["lateral_max"], 0) << engine["engine"] << run;
      EXPECT_EQ(run["column_spread"], 0) << engine["engine"] << run;
      // The distance by its definition, of cubes in ascending order.
      ASSERT_EQ(run["y"].size(), 9U);
      double sum = 0, all = 0;
      for (std::size_t i = 0; i < 9; ++i) {
        sum += std::fabs(run["y"][i].get<double>() - runs[0]["y"][i].get<double>());
        all += run["y"][i].get<double>();
        EXPECT_GE(run["y"][i], run["y"][i == 0 ? 0 : i - 1]);
      }
      EXPECT_NEAR(run["from_limit"].get<double>(), sum / 9, 1e-12);
      EXPECT_NEAR(run["mean_y"].get<double>(), all / 9, 1e-12);
      // Three equal columns: the last three are the farthest row.
      EXPECT_NEAR(run["farthest_row"].get<double>(), run["y"][8].get<double>(), 1e-12);
    }
  }
}

TEST(Bench, PeersRunBothMethodsOfOurs) {
  const Workshop shop;
  const Json results = bench(shop, {"peers", "--scene", "grid_6_coarse", "--repeat", "1", "--engine", "thesis"});
  const Json& engines = results["scenes"][0]["engines"];
  ASSERT_EQ(engines.size(), 2U);
  EXPECT_TRUE(engines[0]["engine"].get<std::string>().ends_with("layered"));
  EXPECT_TRUE(engines[1]["engine"].get<std::string>().ends_with("thesis"));
  EXPECT_NE(engines[0]["drift_max"], engines[1]["drift_max"]);
  for (const Json& engine : engines) {
    EXPECT_EQ(engine["failure"], "");
    EXPECT_EQ(engine["lateral_max"], 0);
    EXPECT_EQ(engine["order_error"], 0);
  }
}

TEST(Bench, ScalingLeavesOutWhatIsTooMuch) {
  const Workshop shop;
  const Json results = bench(shop, {"scaling", "--budget", "0.5"});
  EXPECT_GE(results["points"].size(), 1U);
  for (const Json& point : results["points"]) EXPECT_LT(point["bodies"], 102400);
}

TEST(Bench, MemoryIsToldByBodyAndByContact) {
  const Workshop shop;
  const Json results = bench(shop, {"memory", "--scene", "layered_tower_5", "--scene", "pyramid"});
  ASSERT_EQ(results["scenes"].size(), 2U);
  for (const Json& scene : results["scenes"]) {
    EXPECT_GT(scene["contacts"], 0) << scene;
    EXPECT_GT(scene["bytes_per_body"], 300) << scene;
    EXPECT_GT(scene["bytes_per_contact"], 100) << scene;
    std::size_t sum = 0;
    for (const Json& part : scene["parts"]) sum += part["bytes"].get<std::size_t>();
    EXPECT_EQ(scene["bytes"], sum);
  }
}

TEST(Bench, ViewMeasuresAServedPage) {
  const Workshop shop;
  const Outcome outcome = shop.run({"bench", "view", "--scene", "grid_3", "--json"});
  if (outcome.exit == 4 && outcome.err.find("libcpp-httplib-dev") != std::string::npos) GTEST_SKIP() << outcome.err;
  ASSERT_EQ(outcome.exit, 0) << outcome.err;
  const Json row = Json::parse(outcome.out)["row"];
  EXPECT_EQ(row["bodies"], 9);
  EXPECT_EQ(row["steps"], 1500);
  for (const char* figure : {"ready", "open", "timeline", "contacts_begun", "megabytes", "cpu"}) {
    EXPECT_GT(row[figure], 0) << figure;
  }
  for (const char* seek : {"seek", "seek_while_reading"}) {
    EXPECT_GE(row[seek]["most"], row[seek]["median"]);
    EXPECT_GT(row[seek]["median"], 0);
  }
}

TEST(Bench, ExportMeasuresEveryFormat) {
  const Workshop shop;
  const Json json = bench(shop, {"export", "--scene", "grid_3", "--repeat", "2"});
  EXPECT_EQ(json["bodies"], 9);
  EXPECT_DOUBLE_EQ(json["raw_megabytes"].get<double>(), 9 * 1501 * 104 / 1e6);
  std::vector<std::string> formats;
  for (const Json& row : json["rows"]) {
    formats.push_back(row["format"]);
    if (row.contains("left_out")) continue;
    EXPECT_DOUBLE_EQ(row["megabytes_per_second"].get<double>() * row["seconds"].get<double>(),
                     json["raw_megabytes"].get<double>());
    for (const char* figure : {"seconds", "cpu", "megabytes", "bytes"}) EXPECT_GT(row[figure], 0) << figure;
  }
  EXPECT_EQ(formats, (std::vector<std::string>{"npz", "mcap", "glb"}));
}

TEST(Bench, BadArgumentsAreStatusTwo) {
  const Workshop shop;
  EXPECT_EQ(shop.run({"bench", "export", "--scene", "tower_20"}).exit, 2);
  EXPECT_EQ(shop.run({"bench", "view", "--scene", "tower_20"}).exit, 2);
  EXPECT_EQ(shop.run({"bench", "everything"}).exit, 2);
  EXPECT_EQ(shop.run({"bench", "table1", "--method", "other"}).exit, 2);
  EXPECT_EQ(shop.run({"bench", "peers", "--scene", "no_such"}).exit, 2);
  EXPECT_EQ(shop.run({"bench", "accuracy", "--scene", "tower_20"}).exit, 2);
  EXPECT_EQ(shop.run({"bench", "accuracy", "--scene", "grid_0"}).exit, 2);
  EXPECT_EQ(shop.run({"bench", "peers", "--scene", "grid_6_coarse", "--scene", "no_such"}).exit, 2);
  for (const char* what : {"accuracy", "peers", "table1"}) {
    const Outcome outcome = shop.run({"bench", what, "--engine", "layered", "--engine", "no_such"});
    EXPECT_EQ(outcome.exit, 2) << what;
    EXPECT_NE(outcome.err.find("found \"no_such\", wanted"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(shop.run({"bench", "memory", "--scene", "no_such"}).exit, 2);
  const std::vector<std::vector<std::string>> others = {
      {"memory", "--budget", "1"},     {"memory", "--engine", "thesis"}, {"view", "--repeat", "3"},
      {"memory", "--plot", "zz.svg"},  {"peers", "--measure"},           {"scaling", "--large"},
      {"live", "--method", "layered"}, {"table1", "--scene", "grid_20"}, {"phases", "--json"},
      {"record", "--save", "x.json"}};
  for (const std::vector<std::string>& words : others) {
    const Outcome outcome = shop.run({"bench", words[0], words[1], words.back()});
    EXPECT_EQ(outcome.exit, 2) << words[0] << words[1];
    EXPECT_NE(outcome.err.find(words[1] + ": found with bench " + words[0]), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("wanted with "), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(shop.run({"bench", "scaling", "--budget", "0.3", "--plot", "x.txt"}).exit, 2);
}

}  // namespace
}  // namespace tumble::test
