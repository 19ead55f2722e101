// The benchmarks give figures of what they say they measure, and say what they left out.
#include <gtest/gtest.h>

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

TEST(Bench, TableOneRunsWhatTheBudgetAllowsAndEstimatesTheRest) {
  const Workshop shop;
  const Json results = bench(shop, {"table1", "--budget", "0.3", "--save", "table1.json"});
  ASSERT_EQ(results["cells"].size(), 70U);
  std::size_t run = 0;
  for (const Json& cell : results["cells"]) {
    EXPECT_NEAR(cell["ratio"].get<double>() * cell["cpu_s"].get<double>(), cell["thesis_s"].get<double>(), 1e-6);
    if (cell["estimated"] == true) continue;
    ++run;
    EXPECT_EQ(cell["lateral_max"], 0) << cell;
    EXPECT_EQ(cell["lost"], 0) << cell;
  }
  EXPECT_EQ(results["cells_run"], run);
  EXPECT_GT(run, 0U);
  EXPECT_LT(run, 70U);
  EXPECT_GT(results["estimated_rest_s"], 0);
  EXPECT_EQ(Json::parse(shop.read("table1.json"))["cells"], results["cells"]);
  EXPECT_FALSE(results["machine"]["flags"].get<std::string>().empty());
}

TEST(Bench, TableOneEstimatesBothHalvesWithAnyBudget) {
  const Workshop shop;
  const Json results = bench(shop, {"table1", "--budget", "0.000001"});
  EXPECT_EQ(results["cells_run"], 2);
  for (const Json& cell : results["cells"]) EXPECT_GT(cell["ratio"].get<double>(), 0) << cell;
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

TEST(Bench, BadArgumentsAreStatusTwo) {
  const Workshop shop;
  EXPECT_EQ(shop.run({"bench", "everything"}).exit, 2);
  EXPECT_EQ(shop.run({"bench", "table1", "--method", "other"}).exit, 2);
  EXPECT_EQ(shop.run({"bench", "peers", "--scene", "no_such"}).exit, 2);
  EXPECT_EQ(shop.run({"bench", "memory", "--scene", "no_such"}).exit, 2);
  EXPECT_EQ(shop.run({"bench", "scaling", "--budget", "0.3", "--plot", "x.txt"}).exit, 2);
}

}  // namespace
}  // namespace tumble::test
