// `tumble diff` and `replay` as a person runs them: what a difference led to, one step side by side, the plot.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/program.h"
#include "tests/tools/json_output.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/log_writer.h"
#include "tumble/replay/session.h"
#include "tumble/sim/step.h"

namespace tumble::test {
namespace {

using nlohmann::ordered_json;

/// Two sessions, in the second of which the thrown box is faster; they differ from step 5 on.
void record_two(const Workshop& shop) {
  shop.record_small("a");
  shop.record_small("b", {"--set", "input.1.velocity=[0.0, 6.5, 0.0]"});
}

TEST(DiffCommand, TellsWhatADifferenceLedTo) {
  const Workshop shop;
  record_two(shop);
  const Outcome outcome = shop.run({"diff", "a.tumble", "b.tumble", "--json"});
  ASSERT_EQ(outcome.exit, 1) << outcome.err;
  const ordered_json json = ordered_json::parse(outcome.out);
  const ordered_json& after = json["aftermath"];
  EXPECT_EQ(after["kind"], "contacts");
  EXPECT_EQ(after["marks"].size(), 5U);
  EXPECT_EQ(after["marks"][0]["step"], 5);
  EXPECT_EQ(after["steps"].size(), 36U);
  EXPECT_EQ(after["steps"][0]["bodies"], 1);
  EXPECT_GT(after["largest"]["gap"], 0.1);
  EXPECT_FALSE(after["metrics"].empty());
  EXPECT_EQ(json["narrowed"]["this_build_follows"], "both");
  EXPECT_EQ(json["effect"]["step"], 5);
  EXPECT_EQ(json["effect"]["phase"], "inputs") << "no phase comes before them";
  const Outcome text = shop.run({"diff", "a.tumble", "b.tumble"});
  EXPECT_NE(text.out.find("effect  step 5, from its inputs on, body "), std::string::npos) << text.out;
  for (const char* words :
       {"separation above 1e-12 m", "largest separation", "bodies that differ", "metric that moved", "inputs"}) {
    EXPECT_NE(text.out.find(words), std::string::npos) << text.out;
  }
}

/// Writes the session of a log as a build with phase hashes of version 1 did: with other words for the phases, and with
/// the states of today, which no log of such a build has any more.
void write_with_older_phase_hashes(const std::string& from, const std::string& to) {
  Result<replay::LogReader> log = replay::LogReader::open(from);
  ASSERT_TRUE(log.ok()) << log.error().message;
  replay::LogHeader header = log->header();
  header.phase_hash_version = 1;
  Result<replay::Session> session = replay::Session::start(header.scene);
  ASSERT_TRUE(session.ok()) << session.error().message;
  auto writer = replay::LogWriter::create(to, header, session->world().state());
  ASSERT_TRUE(writer.ok()) << writer.error().message;
  sim::PhaseHashes hashes;
  for (std::uint64_t k = 1; k <= header.scene.steps; ++k) {
    hashes.clear();
    const Result<replay::TakenStep> taken = session->step({}, &hashes);
    ASSERT_TRUE(taken.ok()) << taken.error().message;
    std::vector<std::uint64_t> words = hashes.words();
    for (std::uint64_t& word : words) word ^= 1;
    const sim::WorldState& state = session->world().state();
    ASSERT_TRUE((*writer)->append({state.def.dt, taken->inputs, words, taken->counters}, state).ok());
  }
  ASSERT_TRUE((*writer)->finish().ok());
}

TEST(DiffCommand, ALogThatAgreesWithNoOtherIsSaidToBeAlone) {
  const Workshop shop;
  record_two(shop);
  shop.record_small("c", {"--set", "input.1.velocity=[0.0, 7.5, 0.0]"});
  const Outcome three = shop.run({"diff", "a.tumble", "b.tumble", "c.tumble"});
  EXPECT_EQ(three.exit, 1) << three.err;
  EXPECT_NE(three.out.find("  alone    a.tumble\n"), std::string::npos) << three.out;
  EXPECT_EQ(three.out.find("  agree "), std::string::npos) << three.out;
}

TEST(DiffCommand, SaysThatOlderPhaseHashesWereNotCompared) {
  const Workshop shop;
  const std::string scene = TUMBLE_SOURCE_DIR "/tests/data/frozen.toml";
  const std::string versions = "phase hashes: version 1 and " + std::to_string(sim::PhaseHashes::kVersion);
  for (const char* method : {"thesis", "layered"}) {
    const std::string setting = "world.method=\"" + std::string(method) + '"';
    ASSERT_EQ(shop.run({"record", scene, "--set", setting, "-o", "new.tumble"}).exit, 0);
    write_with_older_phase_hashes(shop.path("new.tumble"), shop.path("old.tumble"));
    const Outcome replayed = shop.run({"replay", "old.tumble"}),
                  diffed = shop.run({"diff", "old.tumble", "new.tumble"});
    for (const Outcome& outcome : {replayed, diffed}) {
      EXPECT_EQ(outcome.exit, 0) << outcome.out << outcome.err;
      EXPECT_NE(outcome.out.find("identical: 40 steps"), std::string::npos) << outcome.out;
      EXPECT_NE(outcome.out.find(versions), std::string::npos) << outcome.out;
    }
    const ordered_json again = ordered_json::parse(shop.run({"replay", "old.tumble", "--json"}).out);
    EXPECT_EQ(again["notes"].size(), 1U) << again["notes"];
    const ordered_json step =
        ordered_json::parse(shop.run({"diff", "old.tumble", "new.tumble", "--step", "30", "--json"}).out);
    EXPECT_EQ(step["same"], true);
    EXPECT_TRUE(step["phases"].empty());
    EXPECT_FALSE(step["note"].get<std::string>().empty());
  }
}

// Logs that builds of that time wrote.
TEST(DiffCommand, ComparesOlderLogsWithLaterOnesButForPhaseHashes) {
  const Workshop shop;
  const std::string old = TUMBLE_SOURCE_DIR "/tests/data/format_1.2_layered.tumble";
  const Outcome diffed = shop.run({"diff", old, TUMBLE_SOURCE_DIR "/tests/data/format_1.3_hashes_3_layered.tumble"});
  EXPECT_EQ(diffed.exit, 0) << diffed.err;
  EXPECT_NE(diffed.out.find("identical: 40 steps"), std::string::npos) << diffed.out;
  EXPECT_NE(diffed.out.find("phase hashes: version 1 and 3"), std::string::npos) << diffed.out;
  EXPECT_EQ(ordered_json::parse(shop.run({"replay", old, "--json"}).out)["notes"].size(), 2U);
}

TEST(DiffCommand, BriefSaysOnlyWhere) {
  const Workshop shop;
  record_two(shop);
  const Outcome outcome = shop.run({"diff", "a.tumble", "b.tumble", "--brief", "--json"});
  ASSERT_EQ(outcome.exit, 1);
  const ordered_json json = ordered_json::parse(outcome.out);
  EXPECT_FALSE(json.contains("aftermath"));
  EXPECT_EQ(json["first"]["step"], 5);
}

TEST(DiffCommand, ShowsAStepSideBySide) {
  const Workshop shop;
  record_two(shop);
  EXPECT_EQ(shop.run({"diff", "a.tumble", "b.tumble", "--step", "4"}).exit, 0);
  EXPECT_EQ(shop.run({"diff", "a.tumble", "b.tumble", "--step", "0"}).exit, 0);
  const Outcome outcome = shop.run({"diff", "a.tumble", "b.tumble", "--step", "5", "--json"});
  ASSERT_EQ(outcome.exit, 1) << outcome.err;
  const ordered_json json = ordered_json::parse(outcome.out);
  EXPECT_EQ(json["same"], false);
  EXPECT_EQ(json["phases"][0]["phase"], "integrate");
  EXPECT_EQ(json["phases"][0]["same"], false);
  ASSERT_EQ(json["bodies"].size(), 1U);
  EXPECT_EQ(json["bodies"][0]["fields"][0]["field"], "velocity.y");
  EXPECT_EQ(json["bodies"][0]["fields"][0]["a"], 6.0);
  EXPECT_EQ(json["bodies"][0]["fields"][0]["b_hex"], "0x401a000000000000");
  EXPECT_EQ(json["contacts"]["a_as_recorded"], true);
  const Outcome text = shop.run({"diff", "a.tumble", "b.tumble", "--step", "30"});
  EXPECT_EQ(text.exit, 1);
  EXPECT_NE(text.out.find("DIFFERENT"), std::string::npos);
  EXPECT_EQ(shop.run({"diff", "a.tumble", "b.tumble", "--step", "41"}).exit, 2);
  EXPECT_EQ(shop.run({"diff", "a.tumble", "b.tumble", "--step", "4", "--brief"}).exit, 2);
  EXPECT_EQ(shop.run({"diff", "a.tumble", "b.tumble", "--step", "4", "--tolerance", "position=1"}).exit, 2);
}

TEST(DiffCommand, DrawsTheGap) {
  const Workshop shop;
  record_two(shop);
  ASSERT_EQ(shop.run({"diff", "a.tumble", "b.tumble", "--plot", "gap.svg"}).exit, 1);
  EXPECT_NE(shop.read("gap.svg").find("bodies that differ"), std::string::npos);
  EXPECT_EQ(shop.run({"diff", "a.tumble", "b.tumble", "--plot", "gap.gif"}).exit, 2);
  EXPECT_EQ(shop.run({"diff", "a.tumble", "a.tumble", "--plot", "same.svg"}).exit, 4) << "there is nothing to draw";
}

TEST(DiffCommand, LooksAtTheStatesOfLogsWithTheSameHashes) {
  const Workshop shop;
  shop.record_small("a");
  shop.record_small("b");
  const Outcome outcome = shop.run({"diff", "a.tumble", "b.tumble", "--json"});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_FALSE(ordered_json::parse(outcome.out).contains("aftermath"));
}

TEST(ReplayCommand, HasNothingToTellOfASessionThatReplays) {
  const Workshop shop;
  shop.record_small("a");
  const Outcome outcome = shop.run({"replay", "a.tumble", "--json"});
  EXPECT_EQ(outcome.exit, 0);
  EXPECT_FALSE(ordered_json::parse(outcome.out).contains("aftermath"));
}

TEST(Program, DiffNamesTheFirstDifference) {
  const Workshop shop;
  shop.record_small("a");
  shop.record_small("b", {"--set", "input.1.velocity=[0.0, 6.000000001, 0.0]"});
  const Outcome text = shop.run({"diff", "a.tumble", "b.tumble"});
  EXPECT_EQ(text.exit, 1);
  EXPECT_NE(text.out.find("header: input 1 throw.velocity.y: 6 → 6.000000001"), std::string::npos) << text.out;
  const Outcome outcome = shop.run({"diff", "a.tumble", "b.tumble", "--json"});
  EXPECT_EQ(outcome.exit, 1);
  const ordered_json json = parsed(outcome);
  EXPECT_EQ(json["identical"], false);
  EXPECT_EQ(keys_of(json["first"]),
            (std::vector<std::string>{"step", "substep", "phase", "body", "pair", "field", "expected", "actual", "ulps",
                                      "expected_hex", "actual_hex", "note"}));
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

}  // namespace
}  // namespace tumble::test
