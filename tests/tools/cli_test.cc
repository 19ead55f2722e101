// The program does what docs/commands.md says: run for real, judged by exit status, stdout and stderr.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "replay/log/log_reader.h"
#include "replay/measure/metric_list.h"
#include "tests/support/program.h"

namespace tumble::test {
namespace {

using nlohmann::ordered_json;

ordered_json parsed(const Outcome& outcome) {
  ordered_json json = ordered_json::parse(outcome.out, nullptr, false);
  EXPECT_FALSE(json.is_discarded()) << "not JSON: " << outcome.out;
  return json;
}

std::vector<std::string> keys_of(const ordered_json& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  return keys;
}

TEST(Program, HelpAndVersionGoToStdout) {
  const Workshop shop;
  EXPECT_EQ(shop.run({"--version"}).out, "tumble " TUMBLE_VERSION "\n");
  const std::string overview = shop.run({"help"}).out;
  for (const char* command : {"record", "replay", "diff", "info", "measure", "dump", "scenes"}) {
    EXPECT_NE(overview.find(command), std::string::npos) << command;
    const Outcome help = shop.run({command, "--help"});
    EXPECT_EQ(help.exit, 0);
    EXPECT_NE(help.out.find("Examples:\n  tumble " + std::string(command)), std::string::npos) << help.out;
    EXPECT_EQ(shop.run({"help", command}).out, help.out);
  }
}

TEST(Program, RecordsAndReplaysToTheBit) {
  const Workshop shop;
  shop.write("s.toml", kSmallScene);
  const Outcome recorded = shop.run({"record", "s.toml"});
  ASSERT_EQ(recorded.exit, 0) << recorded.err;
  EXPECT_NE(recorded.out.find("bytes per moving body-step"), std::string::npos) << recorded.out;
  const Outcome replayed = shop.run({"replay", "s.tumble", "--threads", "2"});
  EXPECT_EQ(replayed.exit, 0) << replayed.err;
  EXPECT_NE(replayed.out.find("identical: 40 steps"), std::string::npos) << replayed.out;
  const ordered_json json = parsed(shop.run({"replay", "s.tumble", "--json"}));
  EXPECT_EQ(json, ordered_json::parse(R"({"identical":true,"steps":40,"first":null,"notes":[]})"));
}

TEST(Program, ASessionInRealTimeReplaysToTheBit) {
  const Workshop shop;
  shop.write("s.toml", kSmallScene);
  const ordered_json json = parsed(shop.run({"record", "s.toml", "--realtime", "--set", "world.dt=0.004", "--json"}));
  EXPECT_EQ(json["steps"], 40);
  EXPECT_EQ(json["frames"]["met"].get<int>() + json["frames"]["missed"].get<int>(), 40) << "every frame counts once";
  Result<replay::LogReader> log = replay::LogReader::open(shop.path("s.tumble"));
  ASSERT_TRUE(log.ok());
  for (std::uint64_t k = 1; k <= 40; ++k) {
    const Result<const replay::StepRecord*> step = log->read_step(k);
    ASSERT_TRUE(step.ok());
    EXPECT_GE((*step)->dt, 0.002);
    EXPECT_LE((*step)->dt, 0.016) << "four frames at most, however slow the machine";
    const auto& inputs = (*step)->inputs;
    EXPECT_TRUE(
        std::ranges::any_of(inputs, [](const sim::Command& c) { return std::holds_alternative<sim::SetDt>(c); }))
        << "step " << k;
  }
  EXPECT_EQ(shop.run({"replay", "s.tumble", "--brief"}).exit, 0);
  EXPECT_EQ(parsed(shop.run({"record", "s.toml", "--json"}))["frames"], nullptr);
  const Outcome refused = shop.run({"record", "s.toml", "--longest-step", "1"});
  EXPECT_EQ(refused.exit, 2);
  EXPECT_NE(refused.err.find("--realtime"), std::string::npos) << refused.err;
}

TEST(Program, RecordFindsGoldenCasesFromTheCurrentFolderUpwards) {
  const Workshop shop;
  shop.write("x", "");  // so that the folder is not empty
  ASSERT_EQ(mkdir(shop.path("golden").c_str(), 0700), 0);
  ASSERT_EQ(mkdir(shop.path("golden/cases").c_str(), 0700), 0);
  ASSERT_EQ(mkdir(shop.path("golden/cases/mine").c_str(), 0700), 0);
  shop.write("golden/cases/mine/scene.toml", kSmallScene);
  const ordered_json scenes = parsed(shop.run({"scenes", "--json"}));
  ASSERT_EQ(scenes.size(), 1U);
  EXPECT_EQ(scenes[0]["name"], "mine");
  EXPECT_EQ(scenes[0]["bodies"], 3);
  EXPECT_EQ(scenes[0]["steps"], 40);
  const ordered_json recorded = parsed(shop.run({"record", "mine", "--steps", "10", "--json"}));
  EXPECT_EQ(recorded["log"], "mine.tumble");
  EXPECT_EQ(recorded["steps"], 10);
  EXPECT_EQ(recorded["bodies"], 3);
}

TEST(Program, EveryStatesModeTellsTheSame) {
  const Workshop shop;
  shop.record_small("all");
  shop.record_small("some", {"--states", "every:7"});
  shop.record_small("none", {"--states", "hashes"});
  ordered_json all = parsed(shop.run({"measure", "all.tumble", "--json"}));
  all.erase("log");
  for (const std::string log : {"some.tumble", "none.tumble"}) {
    EXPECT_EQ(shop.run({"replay", log}).exit, 0);
    EXPECT_EQ(shop.run({"diff", "all.tumble", log}).exit, 0);
    EXPECT_EQ(shop.run({"dump", log, "--step", "33", "--csv"}).out,
              shop.run({"dump", "all.tumble", "--step", "33", "--csv"}).out);
    ordered_json metrics = parsed(shop.run({"measure", log, "--json"}));
    metrics.erase("log");
    EXPECT_EQ(metrics, all) << log;
  }
}

TEST(Program, MeasureKeepsItsContract) {
  const Workshop shop;
  shop.record_small("s");
  const ordered_json json = parsed(shop.run({"measure", "s.tumble", "--json", "--series", "s.csv"}));
  using Keys = std::vector<std::string>;
  EXPECT_EQ(keys_of(json), (Keys{"log", "bodies", "steps", "symmetry", "energy", "stacking", "final_hash"}));
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
  EXPECT_EQ(nowhere.exit, 4);
  EXPECT_NE(nowhere.err.find("no/such/folder.svg: gnuplot could not write it"), std::string::npos) << nowhere.err;
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

TEST(Program, GoesOnFromAStepOfALog) {
  const Workshop shop;
  shop.record_small("s");
  const Outcome outcome = shop.run({"record", "--from", "s.tumble:3"});
  ASSERT_EQ(outcome.exit, 0) << outcome.err;
  const std::string rest = "s_from_3.tumble";
  EXPECT_EQ(shop.run({"diff", "s.tumble", rest}).exit, 0);
  EXPECT_EQ(shop.run({"replay", rest}).exit, 0);
  EXPECT_EQ(shop.run({"measure", rest}).exit, 0);
  EXPECT_EQ(shop.run({"dump", rest, "--step", "2"}).exit, 2);
  EXPECT_EQ(shop.run({"dump", rest, "--steps", "3:40", "--csv"}).out,
            shop.run({"dump", "s.tumble", "--steps", "3:40", "--csv"}).out);
  const ordered_json info = parsed(shop.run({"info", rest, "--json"}));
  EXPECT_EQ(info["goes_on"]["step"], 3);
  EXPECT_EQ(info["first_state"], 3);
  EXPECT_EQ(info["steps"], 37);
  EXPECT_EQ(shop.run({"record", "--from", "s.tumble:3", "--no-inputs", "-o", "quiet.tumble"}).exit, 0);
  EXPECT_EQ(shop.run({"diff", "s.tumble", "quiet.tumble"}).exit, 1);
}

TEST(Program, GoingOnSaysWhatItCannotDo) {
  const Workshop shop;
  shop.record_small("s");
  const std::vector<std::vector<std::string>> wrong = {
      {"record"},
      {"record", "--from", "s.tumble"},
      {"record", "--from", "s.tumble:41"},
      {"record", "--from", "s.tumble:40"},
      {"record", "--from", "s.tumble:3", "-o", "s.tumble"},
      {"record", "--from", "s.tumble:3", "--mirror", "x"},
      {"record", "--from", "s.tumble:3", "--set", "world.dt=0.1"},
      {"record", "s.toml", "--from", "s.tumble:3"},
      {"record", "s.toml", "--no-inputs"},
  };
  for (const std::vector<std::string>& arguments : wrong) {
    const Outcome outcome = shop.run(arguments);
    EXPECT_EQ(outcome.exit, 2) << outcome.out << outcome.err;
    EXPECT_FALSE(outcome.err.empty());
  }
}

TEST(Program, DiffNamesTheFirstDifference) {
  const Workshop shop;
  shop.record_small("a");
  shop.record_small("b", {"--set", "input.1.velocity=[0.0, 6.000000001, 0.0]"});
  const Outcome text = shop.run({"diff", "a.tumble", "b.tumble"});
  EXPECT_EQ(text.exit, 1);
  EXPECT_NE(text.out.find("inputs: not the same script"), std::string::npos) << text.out;
  const Outcome outcome = shop.run({"diff", "a.tumble", "b.tumble", "--json"});
  EXPECT_EQ(outcome.exit, 1);
  const ordered_json json = parsed(outcome);
  EXPECT_EQ(json["identical"], false);
  EXPECT_EQ(keys_of(json["first"]),
            (std::vector<std::string>{"step", "substep", "phase", "body", "pair", "field", "expected", "actual", "ulps",
                                      "expected_hex", "actual_hex"}));
  EXPECT_EQ(json["first"]["step"], 5);
}

TEST(Program, DiffForgivesWhatTolerancesAllow) {
  const Workshop shop;
  shop.record_small("a", {"--steps", "12"});  // before a first touch makes the gap grow
  shop.record_small("b", {"--steps", "12", "--set", "box.2.position=[0.1, 0.2, 2.000000001]"});
  const std::vector<std::string> diff = {"diff", "a.tumble", "b.tumble"};
  EXPECT_EQ(shop.run(diff).exit, 1);
  std::vector<std::string> loose = diff;
  for (const char* field : {"position", "orientation", "velocity", "spin"}) {
    loose.insert(loose.end(), {"--tolerance", std::string(field) + "=1e-3"});
  }
  EXPECT_EQ(shop.run(loose).exit, 0) << shop.run(loose).out;
  std::vector<std::string> tight = diff;
  tight.insert(tight.end(), {"--tolerance", "position=1e-12", "--json"});
  const ordered_json first = parsed(shop.run(tight))["first"];
  EXPECT_EQ(first["step"], 0);
  EXPECT_EQ(first["phase"], "start");
  EXPECT_EQ(first["body"], 2);
  EXPECT_EQ(first["field"], "position.z");
}

TEST(Program, DiffOfDifferentLengthsIsADifference) {
  const Workshop shop;
  shop.record_small("a");
  shop.record_small("b", {"--steps", "30"});
  const Outcome outcome = shop.run({"diff", "a.tumble", "b.tumble", "--json"});
  EXPECT_EQ(outcome.exit, 1);
  const ordered_json json = parsed(outcome);
  EXPECT_EQ(json["identical"], false);
  EXPECT_EQ(json["steps"], 30);
  EXPECT_EQ(json["first"]["step"], 31);
  EXPECT_EQ(json["first"]["field"], "steps");
}

// Every number that dump prints is the one in the log, to the bit.
TEST(Program, DumpedNumbersReadBackToTheSameBits) {
  const Workshop shop;
  shop.record_small("s");
  Result<replay::LogReader> log = replay::LogReader::open(shop.path("s.tumble"));
  ASSERT_TRUE(log.ok());
  const auto record = log->read_step(37);
  ASSERT_TRUE(record.ok());
  const replay::BodyStates& states = (*record)->states;
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };

  const ordered_json json = parsed(shop.run({"dump", "s.tumble", "--step", "37", "--json"}));
  EXPECT_EQ(json["step"], 37);
  ASSERT_EQ(json["bodies"].size(), states.size());
  std::istringstream csv(shop.run({"dump", "s.tumble", "--step", "37", "--csv"}).out);
  std::string line;
  std::getline(csv, line);
  EXPECT_TRUE(line.starts_with("step,id,position.x,")) << line;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const std::vector<double> wanted = {states.position.x[i],    states.position.y[i],    states.position.z[i],
                                        states.orientation.w[i], states.orientation.x[i], states.orientation.y[i],
                                        states.orientation.z[i], states.velocity.x[i],    states.velocity.y[i],
                                        states.velocity.z[i],    states.spin.x[i],        states.spin.y[i],
                                        states.spin.z[i]};
    std::getline(csv, line);
    std::istringstream cells(line);
    std::string cell;
    std::getline(cells, cell, ',');
    std::getline(cells, cell, ',');
    EXPECT_EQ(cell, std::to_string(states.id[i]));
    std::vector<double> numbers;
    for (const char* key : {"position", "orientation", "velocity", "spin"}) {
      for (const auto& number : json["bodies"][i][key]) numbers.push_back(number.get<double>());
    }
    ASSERT_EQ(numbers.size(), wanted.size());
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      EXPECT_EQ(bits(numbers[k]), bits(wanted[k]));
      std::getline(cells, cell, ',');
      EXPECT_EQ(bits(std::stod(cell)), bits(wanted[k])) << cell;
    }
  }
}

TEST(Program, DumpFollowsOneBodyThroughItsSteps) {
  const Workshop shop;
  shop.record_small("s");
  const std::string csv = shop.run({"dump", "s.tumble", "--steps", "3:6", "--body", "3", "--csv"}).out;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3) << "a header, and steps 5 and 6: thrown in before step 5\n"
                                                         << csv;
  const ordered_json list = parsed(shop.run({"dump", "s.tumble", "--steps", "0:2", "--json"}));
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[2]["step"], 2);
  EXPECT_EQ(list[0]["bodies"].size(), 2U);
}

TEST(Program, InfoTellsWhatALogHolds) {
  const Workshop shop;
  shop.record_small("s", {"--set", "world.substeps=4"});
  const Outcome outcome = shop.run({"info", "s.tumble", "--json"});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  const ordered_json json = parsed(outcome);
  EXPECT_EQ(json["method"], "thesis");
  EXPECT_EQ(json["scene"]["title"], "three boxes");
  EXPECT_EQ(json["set"][0], "world.substeps=4");
  EXPECT_EQ(json["bodies"], 3);
  EXPECT_EQ(json["bodies_at_start"], 2);
  EXPECT_EQ(json["steps"], 40);
  EXPECT_EQ(json["inputs"], ordered_json::parse(R"({"throw":1})"));
  EXPECT_EQ(json["bytes"], shop.read("s.tumble").size());
  EXPECT_EQ(json["moving_body_steps"], 2 * 40 + 36);
  EXPECT_EQ(json["whole"], true);
  EXPECT_EQ(json["final_hash"], parsed(shop.run({"measure", "s.tumble", "--json"}))["final_hash"]);
}

}  // namespace
}  // namespace tumble::test
