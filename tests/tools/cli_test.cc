// The program does what docs/commands.md says: run for real, judged by exit status, stdout and stderr. Help, recording
// and replaying.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/program.h"
#include "tests/tools/json_output.h"
#include "tumble/replay/log_reader.h"

namespace tumble::test {
namespace {

using nlohmann::ordered_json;

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
  using Keys = std::vector<std::string>;
  EXPECT_EQ(keys_of(json), (Keys{"schema", "identical", "steps", "first", "notes", "compared", "not_compared"}));
  EXPECT_EQ(json["identical"], true);
  EXPECT_EQ(json["steps"], 40);
  EXPECT_TRUE(json["first"].is_null());
  EXPECT_TRUE(json["notes"].empty());
  for (const char* part : {"inputs", "state hashes", "phase hashes"}) {
    EXPECT_EQ(std::ranges::count(json["compared"], part), 1) << json["compared"];
  }
}

TEST(Program, RecordNamesNoBytesOfMotionWhereNothingMuchMoves) {
  const Workshop shop;
  shop.write("still.toml",
             "[world]\nmethod = \"layered\"\ndt = 0.01\nsteps = 4000\n"
             "[[box]]\nid = 1\nsize = [1, 1, 1]\nmass = 1.0\nposition = [0.0, 0.0, 0.5]\n");
  const Outcome recorded = shop.run({"record", "still.toml"});
  ASSERT_EQ(recorded.exit, 0) << recorded.err;
  EXPECT_EQ(recorded.out.find("per moving body-step"), std::string::npos) << recorded.out;
  const ordered_json json = parsed(shop.run({"record", "still.toml", "--json"}));
  EXPECT_GT(json["moving_body_steps"], 0) << "some steps moved, else there is no figure to leave out";
  EXPECT_FALSE(json["bytes_per_moving_body_step"].is_null());
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
  const auto mine = std::ranges::find_if(scenes, [](const ordered_json& scene) { return scene["name"] == "mine"; });
  ASSERT_NE(mine, scenes.end());
  EXPECT_EQ((*mine)["bodies"], 3);
  EXPECT_EQ((*mine)["steps"], 40);
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

TEST(Program, EveryHashesModeTellsTheSameAndWhatItLeavesOut) {
  const Workshop shop;
  shop.record_small("all");
  shop.record_small("some", {"--hashes", "every:7"});
  shop.record_small("none", {"--hashes", "states"});
  shop.record_small("other", {"--hashes", "states", "--set", "input.1.velocity=[0.0, 6.5, 0.0]"});
  EXPECT_LT(shop.read("none.tumble").size(), shop.read("all.tumble").size());
  const auto left_out = [](const ordered_json& json) {
    const auto of_phases = [](const ordered_json& part) {
      return part.get<std::string>().starts_with("phase hashes of ");
    };
    return std::ranges::any_of(json["not_compared"], of_phases);
  };
  EXPECT_FALSE(left_out(parsed(shop.run({"replay", "all.tumble", "--json"}))));
  for (const std::string log : {"some.tumble", "none.tumble"}) {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"replay", log, "--json"}, {"diff", "all.tumble", log, "--json"}}) {
      const Outcome outcome = shop.run(words);
      EXPECT_EQ(outcome.exit, 0) << outcome.err;
      EXPECT_TRUE(left_out(parsed(outcome))) << outcome.out;
    }
    EXPECT_EQ(parsed(shop.run({"info", log, "--json"}))["hashes"], log == "some.tumble" ? "every:7" : "states");
  }
  const ordered_json step = parsed(shop.run({"diff", "all.tumble", "some.tumble", "--step", "8", "--json"}));
  EXPECT_TRUE(step["phases"].empty() && step["same"].get<bool>()) << step;
  EXPECT_TRUE(step["note"].get<std::string>().starts_with("phase hashes: a log holds none of step 8")) << step;
  const ordered_json found = parsed(shop.run({"diff", "all.tumble", "other.tumble", "--json"}));
  EXPECT_EQ(found["first"]["phase"], "inputs");
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

}  // namespace
}  // namespace tumble::test
