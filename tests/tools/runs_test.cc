// `tumble measure` of several runs of one scene: the spread of each metric, bounds proposed from it, and what such
// bounds catch and let pass. docs/noisy_engines.md.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "src/base/text.h"
#include "tests/support/program.h"
#include "tests/tools/json_output.h"

namespace tumble::test {
namespace {

using nlohmann::ordered_json;

/// A body that slides along x by `way` in 20 steps, in centimetres and with y up; a channel has its load.
std::string sliding(double way, double load = 1) {
  std::string text =
      "# engine: slider\n# dt: 0.01\n# up: y\n# length: cm\nstep,id,position.x,position.y,position.z,orientation.w,"
      "orientation.x,orientation.y,orientation.z,channel.load\n";
  for (int step = 0; step <= 20; ++step) {
    text +=
        std::to_string(step) + ",1," + std::to_string(way * step / 20) + ",50,0,1,0,0,0," + std::to_string(load) + '\n';
  }
  return text;
}

/// Logs run_0.tumble, run_1.tumble … of these ways.
std::vector<std::string> slide(const Workshop& shop, const std::string& name, const std::vector<double>& ways) {
  std::vector<std::string> logs;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const std::string run = name + "_" + std::to_string(k);
    shop.write(run + ".csv", sliding(ways[k], 1 + ways[k] / 1000));
    EXPECT_EQ(shop.run({"import", run + ".csv", "-o", run + ".tumble", "--quiet"}).exit, 0);
    logs.push_back(run + ".tumble");
  }
  return logs;
}

Outcome measure(const Workshop& shop, std::vector<std::string> logs, const std::vector<std::string>& options = {}) {
  logs.insert(logs.begin(), "measure");
  logs.insert(logs.end(), options.begin(), options.end());
  return shop.run(logs);
}

ordered_json metric_of(const ordered_json& json, const std::string& name) {
  for (const ordered_json& metric : json["metrics"]) {
    if (metric["name"] == name) return metric;
  }
  ADD_FAILURE() << name << " is not among " << json;
  return {};
}

TEST(Runs, TheSpreadOfEachMetricAndBoundsWiderByItAreTold) {
  const Workshop shop;
  const std::vector<std::string> logs = slide(shop, "run", {100, 104, 103, 101});
  const ordered_json json = parsed(measure(shop, logs, {"--json"}));
  EXPECT_EQ(json["different"], 4);
  EXPECT_EQ(json["runs"].size(), 4U);
  const ordered_json drift = metric_of(json, "drift_max");
  EXPECT_EQ(drift["unit"], "cm");
  EXPECT_EQ(drift["values"].size(), 4U);
  EXPECT_NEAR(drift["least"], 100, 1e-9);
  EXPECT_NEAR(drift["median"], 102, 1e-9) << "the mean of the two in the middle";
  EXPECT_NEAR(drift["largest"], 104, 1e-9);
  EXPECT_NEAR(drift["min"], 96, 1e-9);
  EXPECT_NEAR(drift["max"], 108, 1e-9);
  EXPECT_NEAR(drift["unseen"], 4, 1e-9);
  EXPECT_NEAR(drift["certain"], 8, 1e-9);
  EXPECT_NEAR(metric_of(json, "channel.load.max")["spread"], 0.004, 1e-9) << "channels are metrics like others";
  const ordered_json lost = metric_of(json, "lost");
  EXPECT_EQ(lost["max"], 0.0) << "a count that all runs gave";
  EXPECT_TRUE(lost["min"].is_null()) << "no run loses fewer than none";
  const std::string text = measure(shop, logs).out;
  EXPECT_NE(text.find("4, 4 different ones among them"), std::string::npos) << text;
  EXPECT_NE(text.find("up to 2 times in 5"), std::string::npos) << text;
}

TEST(Runs, OneValueOfRunsThatDifferIsNoProofThatThereIsNoOther) {
  const Workshop shop;
  std::vector<std::string> logs = slide(shop, "run", {100, 100});
  const ordered_json alike = parsed(measure(shop, logs, {"--json"}));
  EXPECT_EQ(alike["different"], 1);
  const ordered_json drift = metric_of(alike, "drift_max");
  EXPECT_NEAR(drift["unseen"], 1e-7, 1e-9) << "runs that repeat: to the 1e-9 by which C libraries differ";
  // The same ends by another way: the metrics are those of before, the states are not.
  shop.write("other.csv", replaced(sliding(100, 1.1), "\n10,1,50.000000", "\n10,1,50.010000"));
  ASSERT_EQ(shop.run({"import", "other.csv", "-o", "other.tumble", "--quiet"}).exit, 0);
  logs.emplace_back("other.tumble");
  const ordered_json noisy = parsed(measure(shop, logs, {"--json"}));
  EXPECT_EQ(noisy["different"], 2);
  EXPECT_EQ(noisy["once"], 1) << "two of the three runs are one session";
  EXPECT_NEAR(metric_of(noisy, "drift_max")["spread"], 0, 1e-9);
  EXPECT_NEAR(metric_of(noisy, "drift_max")["unseen"], 1, 1e-6) << "a hundredth of the median";
  const ordered_json sunk = metric_of(noisy, "ground_penetration_max");
  EXPECT_NE(std::string(sunk["without_bound"]).find("no scale"), std::string::npos) << sunk;
}

TEST(Runs, ProposedBoundsHoldTheRunsAndCatchAFault) {
  const Workshop shop;
  const std::vector<std::string> logs = slide(shop, "run", {100, 104, 103});
  const Outcome proposed = measure(shop, logs, {"--propose", "drift_max,channel.load.max,lost"});
  ASSERT_EQ(proposed.exit, 0) << proposed.err;
  EXPECT_NE(
      proposed.out.find("name = \"drift_max\"\nmin = 0.96\nmax = 1.08\nwhy = \"3 runs gave 1 m to 1.04 m; a change "
                        "of up to 0.04 m may pass in every run, one of more than 0.08 m fails in every run\"\n"),
      std::string::npos)
      << proposed.out;
  EXPECT_NE(proposed.out.find("any rise fails"), std::string::npos) << proposed.out;
  shop.write("bounds.toml", proposed.out);
  EXPECT_EQ(measure(shop, logs, {"--bounds", "bounds.toml"}).exit, 0);
  const std::vector<std::string> faulty = slide(shop, "faulty", {107, 109, 112});
  const Outcome judged = measure(shop, faulty, {"--bounds", "bounds.toml"});
  EXPECT_EQ(judged.exit, 1) << judged.out;
  EXPECT_NE(judged.out.find("in 2 of 3 runs"), std::string::npos) << "107 cm passes: unseen\n" << judged.out;
  EXPECT_NE(judged.out.find("1 in some runs: drift_max"), std::string::npos) << judged.out;
  const ordered_json json = parsed(measure(shop, faulty, {"--bounds", "bounds.toml", "--json"}));
  ASSERT_EQ(json["bounds"].size(), 3U);
  EXPECT_EQ(json["bounds"][0]["name"], "drift_max");
  EXPECT_EQ(json["bounds"][0]["broken"], 2);
  EXPECT_EQ(json["bounds"][2]["broken"], 0);
  EXPECT_NEAR(json["bounds"][0]["max"], 108, 1e-9) << "in the unit of the session";
  // One run is judged as several are.
  EXPECT_EQ(measure(shop, {faulty[2]}, {"--bounds", "bounds.toml"}).exit, 1);
}

TEST(Runs, NoLeastIsProposedBelowTheLeastThereCanBe) {
  const Workshop shop;
  std::vector<std::string> logs;
  for (const char* height : {"0.49", "0.3"}) {  // in the ground, which pushes the box out
    shop.write("s.toml", "[world]\nsteps = 12\n[[box]]\nposition = [0.0, 0.0, " + std::string(height) +
                             "]\n[[box]]\nposition = [5.0, 0.0, 3.0]\n");
    logs.push_back(std::string(height) + ".tumble");
    ASSERT_EQ(shop.run({"record", "s.toml", "-o", logs.back(), "--quiet"}).exit, 0);
  }
  const Outcome proposed = measure(shop, logs, {"--propose", "gain_ratio"});
  ASSERT_EQ(proposed.exit, 0) << proposed.err;
  EXPECT_NE(proposed.out.find("max = "), std::string::npos) << proposed.out;
  EXPECT_EQ(proposed.out.find("min = "), std::string::npos) << proposed.out;
}

TEST(Runs, ARunThatWasCutOffIsNamedBesideTheProposedBounds) {
  const Workshop shop;
  const std::vector<std::string> logs = slide(shop, "run", {100, 104, 103});
  const std::string bytes = shop.read(logs[1]);
  shop.write(logs[1], bytes.substr(0, bytes.size() - 200));
  const Outcome proposed = measure(shop, logs, {"--propose", "drift_max"});
  EXPECT_EQ(proposed.exit, 3) << proposed.err;
  EXPECT_NE(proposed.out.find("# run_1.tumble is not whole"), std::string::npos) << proposed.out;
  EXPECT_NE(proposed.err.find("note: run_1.tumble is not whole"), std::string::npos) << proposed.err;
  shop.write("bounds.toml", proposed.out);
  EXPECT_EQ(measure(shop, {logs[0], logs[2]}, {"--bounds", "bounds.toml"}).exit, 0) << "a comment";
}

TEST(Runs, AChoiceOfBodiesAndStepsIsProposedWithTheBound) {
  const Workshop shop;
  const std::vector<std::string> logs = slide(shop, "run", {100, 104});
  const std::string text =
      measure(shop, logs, {"--propose", "lateral_max", "--bodies", "1", "--axis", "z", "--from-step", "10"}).out;
  EXPECT_EQ(text, "") << "0 along z in every run is no bound";
  const Outcome along_x =
      measure(shop, logs, {"--propose", "lateral_max", "--bodies", "1", "--axis", "x", "--from-step", "10"});
  ASSERT_EQ(along_x.exit, 0) << along_x.err;
  EXPECT_NE(along_x.out.find("bodies = \"1\"\naxis = \"x\"\nfrom_step = 10\nmin = 0.48\nmax = 0.54\n"),
            std::string::npos)
      << along_x.out;
  shop.write("bounds.toml", along_x.out);
  EXPECT_EQ(measure(shop, logs, {"--bounds", "bounds.toml"}).exit, 0);
  EXPECT_EQ(measure(shop, slide(shop, "far", {109}), {"--bounds", "bounds.toml"}).exit, 1);
}

TEST(Runs, TheTimeAtWhichRunsPartFromASessionHasALeast) {
  const Workshop shop;
  const std::vector<std::string> logs = slide(shop, "run", {104, 105});
  const std::string reference = slide(shop, "reference", {100}).front();
  const Outcome proposed = measure(shop, logs, {"--against", reference, "--propose", "parting_time.0.01"});
  ASSERT_EQ(proposed.exit, 0) << proposed.err;
  EXPECT_NE(proposed.out.find("against = \"reference_0.tumble\"\nmin = "), std::string::npos) << proposed.out;
  EXPECT_EQ(proposed.out.find("max"), std::string::npos) << "to part later is no fault\n" << proposed.out;
  shop.write("bounds.toml", proposed.out);
  EXPECT_EQ(measure(shop, logs, {"--bounds", "bounds.toml"}).exit, 0);
  EXPECT_EQ(measure(shop, slide(shop, "soon", {150}), {"--bounds", "bounds.toml"}).exit, 1);
}

TEST(Runs, WhatCannotBeAnsweredIsRefusedWithTheReason) {
  const Workshop shop;
  const std::vector<std::string> logs = slide(shop, "run", {100, 104});
  shop.write("m.csv", replaced(sliding(100), "# length: cm\n", ""));
  ASSERT_EQ(shop.run({"import", "m.csv", "-o", "m.tumble", "--quiet"}).exit, 0);
  shop.write("none.toml", "[[metric]]\nname = \"mirror_error\"\nmax = 1\nwhy = \"none\"\n");
  const std::vector<std::pair<std::vector<std::string>, std::string>> asked = {
      {{logs[0], "--propose", "all"}, "one shows no spread"},
      {{logs[0], logs[1], "--propose", "drift"}, "found \"drift\""},
      {{logs[0], logs[1], "--propose", "ground_penetration_max"}, "no scale"},
      {{logs[0], logs[0]}, "twice"},
      {{logs[0], logs[1], "--against", logs[1]}, "one of the runs"},
      {{logs[0], "m.tumble"}, "wanted runs of one scene"},
      {{logs[0], logs[1], "--series", "s.csv"}, "--bounds FILE judges several"},
      {{logs[0], logs[1], "--require", "lost<=0"}, "--bounds FILE judges several"},
      {{logs[0], logs[1], "--bounds", "none.toml"}, "wanted one at least"},
      {{logs[0], logs[1], "--bounds", "none.toml", "--bodies", "1"}, "names its own"},
  };
  for (const auto& [words, message] : asked) {
    const Outcome outcome = measure(shop, words);
    EXPECT_EQ(outcome.exit, 2) << message << '\n' << outcome.out;
    EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
  }
}

TEST(Runs, AMetricThatIsNoNumberInARunHasNoBound) {
  const Workshop shop;
  std::vector<std::string> logs = slide(shop, "run", {100, 104});
  shop.write("lost.csv", replaced(sliding(102), "\n10,1,51.000000", "\n10,1,nan"));
  ASSERT_EQ(shop.run({"import", "lost.csv", "-o", "lost.tumble", "--quiet"}).exit, 0);
  logs.emplace_back("lost.tumble");
  const ordered_json drift = metric_of(parsed(measure(shop, logs, {"--json"})), "drift_max");
  EXPECT_EQ(drift["without_bound"], "not finite in 1 of 3 runs");
  EXPECT_TRUE(drift["max"].is_null());
  shop.write("bounds.toml", "[[metric]]\nname = \"drift_max\"\nmax = 9\nwhy = \"near\"\n");
  EXPECT_EQ(parsed(measure(shop, logs, {"--bounds", "bounds.toml", "--json"}))["bounds"][0]["broken"], 1);
}

// A bound beside which the runs lie passes today and fails some day, without any change.
TEST(Runs, ABoundThatRunsOfACaseComeNearerToThanToOneAnotherIsNamed) {
  const Workshop shop;
  shop.write("table.in", replaced(sliding(100), ",1.000000\n", ",@load\n"));
  shop.write(
      "engine.sh",
      "n=$(cat count 2>/dev/null || echo 0); echo $(((n + 1) % 5)) >count\nsed \"s/@load/1.$n/\" table.in >\"$1\"\n");
  shop.write("tumble.toml", "[engine]\nrun = \"sh engine.sh {log}\"\n");
  shop.write("golden/cases/load/setup.txt", "full");
  const auto rules = [&](const std::string& max) {
    shop.write("golden/cases/load/metrics.toml",
               "require = [\"behaviour\"]\n[engine]\nfiles = [\"setup.txt\"]\nrepeat = 5\n[[metric]]\n"
               "name = \"channel.load.last\"\nvalue = 1.2\nmax = " +
                   max + "\nwhy = \"it bears no more\"\n");
  };
  const std::string near =
      "near a bound: channel.load.last: a run is 0.1 from it, and the runs are up to 0.4 from one "
      "another";
  rules("1.5");
  const Outcome blessed = shop.run({"bless", "load", "--reason", "a test"});
  ASSERT_EQ(blessed.exit, 0) << blessed.err;
  EXPECT_NE(blessed.out.find(near), std::string::npos) << "already when it is blessed\n" << blessed.out;
  const Outcome checked = shop.run({"check", "--report", "r"});
  EXPECT_EQ(checked.exit, 0) << checked.out;
  EXPECT_NE(checked.out.find("nearer to the bound of channel.load.last than to one another"), std::string::npos)
      << checked.out;
  rules("1.9");
  const Outcome far = shop.run({"check", "--report", "r"});
  EXPECT_EQ(far.exit, 0) << far.out;
  EXPECT_EQ(far.out.find("nearer to"), std::string::npos) << far.out;
}

// Steps are compared by their numbers; a reader must know where these are not the same times.
TEST(Runs, DiffSaysHowFarTheClocksOfTwoSessionsAreApart) {
  const Workshop shop;
  const auto falling = [&](const std::string& name, const std::vector<double>& lengths, double start) {
    std::string text =
        "# engine: faller\nstep,dt,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,"
        "orientation.z\n";
    for (std::size_t k = 0; k <= lengths.size(); ++k) {
      text += std::to_string(k) + "," + std::to_string(lengths[k == 0 ? 0 : k - 1]) + ",1," +
              std::to_string(start + static_cast<double>(k)) + ",0,1,1,0,0,0\n";
    }
    shop.write(name + ".csv", text);
    EXPECT_EQ(shop.run({"import", name + ".csv", "-o", name + ".tumble", "--quiet"}).exit, 0);
  };
  falling("a", {0.25, 0.25, 0.25, 0.25, 0.25}, 0);
  falling("b", {0.25, 0.25, 0.5, 0.125, 0.125}, 0);
  falling("moved", {0.25, 0.25, 0.25, 0.25, 0.25}, 0.5);
  const std::string text = shop.run({"diff", "a.tumble", "b.tumble"}).out;
  EXPECT_NE(text.find("  clocks "), std::string::npos) << text;
  EXPECT_NE(
      text.find("up to 0.25 s apart (step 3): steps are compared by their numbers, and differ in length from step "
                "3 on"),
      std::string::npos)
      << text;
  const ordered_json clocks = parsed(shop.run({"diff", "a.tumble", "b.tumble", "--json"}))["aftermath"]["clocks"];
  EXPECT_EQ(clocks["from"], 3);
  EXPECT_EQ(clocks["largest"], 0.25);
  EXPECT_EQ(clocks["largest_step"], 3);
  EXPECT_TRUE(parsed(shop.run({"diff", "a.tumble", "moved.tumble", "--json"}))["aftermath"]["clocks"].is_null());
  EXPECT_EQ(shop.run({"diff", "a.tumble", "moved.tumble"}).out.find("clocks"), std::string::npos);
}

}  // namespace
}  // namespace tumble::test
