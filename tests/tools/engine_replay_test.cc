// `replay` of another engine compares while the engine runs, and says clearly what a broken engine did.
#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/program.h"
#include "tests/tools/engine_table.h"
#include "tests/tools/json_output.h"
#include "tests/tools/stream_toy.h"

namespace tumble::test {
namespace {

using nlohmann::ordered_json;

TEST(EngineReplay, StopsAnEngineThatHangsAtItsFirstDifference) {
  const Workshop shop;
  record_falling(shop, "a");
  write_falling(shop, "--move 5:0.125 --hang 20");
  const Outcome stopped = shop.run({"replay", "a.tumble", "--stop"});
  EXPECT_EQ(stopped.exit, 1) << stopped.err;
  EXPECT_TRUE(says(stopped.err, "step 5 differs already; the engine is stopped")) << stopped.err;
  EXPECT_TRUE(says(stopped.out, "stopped at the first difference")) << stopped.out;
  EXPECT_TRUE(says(stopped.out, "that differs is step 5")) << stopped.out;
  EXPECT_TRUE(says(stopped.out, "position.x")) << stopped.out;
  const ordered_json json = parsed(shop.run({"replay", "a.tumble", "--stop", "--json"}));
  EXPECT_EQ(json["engine_ended"], "stopped");
  EXPECT_EQ(json["first"]["step"], 5);
  EXPECT_EQ(json["first"]["body"], 1);
  EXPECT_EQ(json["first"]["field"], "position.x");
}

TEST(EngineReplay, FindsADifferentChannelWhileTheEngineRuns) {
  const Workshop shop;
  record_falling(shop, "a");
  write_falling(shop, "--seed 6:3 --hang 20");
  const ordered_json json = parsed(shop.run({"replay", "a.tumble", "--stop", "--json"}));
  EXPECT_EQ(json["first"]["field"], "channel.random.seed") << json["first"];
  EXPECT_EQ(json["first"]["step"], 6);
  record_falling(shop, "t", "--table");
  write_falling(shop, "--table --angle 6:3 --hang 20");
  const ordered_json table = parsed(shop.run({"replay", "t.tumble", "--stop", "--json"}));
  EXPECT_EQ(table["first"]["field"], "channel.hinge.angle") << "of the complete steps of a table";
}

TEST(EngineReplay, KeepsItsSessionInPlaceOfALogAlone) {
  const Workshop shop;
  record_falling(shop, "a");
  write_falling(shop);
  shop.write("notes.tumble", "a person's words");
  const Outcome refused = shop.run({"replay", "a.tumble", "-o", "notes.tumble"});
  EXPECT_EQ(refused.exit, 2) << refused.out;
  EXPECT_TRUE(says(refused.err, "notes.tumble: exists and is not a log")) << refused.err;
  EXPECT_EQ(shop.read("notes.tumble"), "a person's words");
  for (int time = 0; time < 2; ++time) {
    const Outcome kept = shop.run({"replay", "a.tumble", "-o", "b.tumble"});
    EXPECT_EQ(kept.exit, 0) << kept.err;
    EXPECT_EQ(shop.run({"diff", "a.tumble", "b.tumble"}).exit, 0);
  }
}

// Nothing but the number of steps that came tells what the engine had planned.
TEST(EngineReplay, AnEngineThatLeavesEarlyHasNotPlannedLess) {
  const Workshop shop;
  record_falling(shop, "a");
  write_falling(shop, "--steps 18");
  const Outcome left = shop.run({"replay", "a.tumble"});
  EXPECT_EQ(left.exit, 1) << left.out;
  EXPECT_TRUE(says(left.out, "18")) << left.out;
  EXPECT_FALSE(says(left.out, "planned steps")) << left.out;
}

TEST(EngineReplay, SaysHowFarABrokenEngineCame) {
  const Workshop shop;
  record_falling(shop, "a");
  write_falling(shop, "--crash 20");
  const Outcome crashed = shop.run({"replay", "a.tumble"});
  EXPECT_EQ(crashed.exit, 4) << crashed.out;
  EXPECT_TRUE(says(crashed.err, "SIGABRT")) << crashed.err;
  EXPECT_TRUE(says(crashed.err, "the 19 steps that it wrote before, up to step 19 of 40, are the same as the log's"))
      << crashed.err;
  write_falling(shop, "--hang 20");
  const Outcome hangs = shop.run({"replay", "a.tumble", "--timeout", "0.5"});
  EXPECT_EQ(hangs.exit, 4) << hangs.out;
  EXPECT_TRUE(says(hangs.err, "the 19 steps that it wrote before")) << hangs.err;
  write_falling(shop, "--hang 20", "timeout = 0.5\n");
  EXPECT_TRUE(says(shop.run({"replay", "a.tumble"}).err, "the 19 steps that it wrote before"));
  write_falling(shop, "--stretched 20");
  const Outcome stretched = shop.run({"replay", "a.tumble"});
  EXPECT_TRUE(says(stretched.err, "step 20: body 1: an orientation of length 2 is logged divided by")) << stretched.err;
  EXPECT_TRUE(says(stretched.out, "only this run has channel told.state.orientation.w")) << stretched.out;
  write_falling(shop, "--move 5:1 --crash 20");
  const Outcome both = shop.run({"replay", "a.tumble"});
  EXPECT_EQ(both.exit, 1) << "a difference is an answer";
  EXPECT_TRUE(says(both.out, "the engine did not end well")) << both.out;
  EXPECT_TRUE(says(both.out, "that differs is step 5")) << both.out;
}

/// The problems of a case whose engine runs with these options.
std::string problems_of(const Workshop& shop, const std::string& options, const std::string& more = "") {
  write_falling(shop, options, more);
  const Outcome checked = shop.run({"check", "--json", "--report", "r"});
  EXPECT_EQ(checked.exit, 1) << checked.out;
  const ordered_json one = parsed(checked)["cases"][0];
  for (const ordered_json& verdict : one["verdicts"]) EXPECT_NE(verdict["outcome"], "pass") << one["verdicts"];
  EXPECT_TRUE(one["metrics"].empty()) << "nothing is measured of half a session";
  return one["problems"].dump();
}

TEST(EngineCheck, SaysHowFarAnEngineThatFailedWasTheSame) {
  const Workshop shop;
  write_falling(shop);
  shop.write("golden/cases/fall/metrics.toml",
             "[engine]\ntitle = \"falling\"\ncategory = \"toys\"\ninputs = \"inputs.txt\"\n"
             "[[metric]]\nname = \"lateral_max\"\nmax = 5\nwhy = \"a test\"\n");
  shop.write("golden/cases/fall/inputs.txt", "\n");
  write_falling(shop, "--crash 20");
  const Outcome unblessed = shop.run({"bless", "fall", "--reason", "a test"});
  EXPECT_NE(unblessed.exit, 0) << "a session that was cut short is no golden";
  write_falling(shop);
  shop.write("golden/cases/fall/inputs.txt", "{}\n");
  const Outcome blessed = shop.run({"bless", "fall", "--reason", "a test"});
  ASSERT_EQ(blessed.exit, 0) << blessed.err;
  ASSERT_EQ(shop.run({"check"}).exit, 0);
  const std::string crashed = problems_of(shop, "--crash 20");
  EXPECT_TRUE(says(crashed, "SIGABRT")) << crashed;
  EXPECT_TRUE(says(crashed, "it wrote 19 steps before it failed, with the same bits as the golden, which has 40 steps"))
      << crashed;
  EXPECT_FALSE(says(crashed, "bless the case")) << crashed;
  const std::string other = problems_of(shop, "--move 5:1 --crash 20");
  EXPECT_TRUE(says(other, "it wrote 19 steps before it failed; first difference: step 5")) << other;
  const std::string hangs = problems_of(shop, "--hang 30", "timeout = 0.5\n");
  EXPECT_TRUE(says(hangs, "it wrote 29 steps before it failed, with the same bits")) << hangs;
  write_falling(shop, "--stretched 20");
  const Outcome stretched = shop.run({"check", "--report", "r"});
  EXPECT_EQ(stretched.exit, 1) << stretched.out;
  EXPECT_TRUE(says(stretched.out, "told what cannot be: body 1 was told state.orientation.w 2 at step 20"))
      << stretched.out;
  const std::string none = problems_of(shop, "--crash 1");
  EXPECT_FALSE(says(none, "it wrote")) << none;
}

TEST(EngineReplay, SaysWhereAStreamIsNotWhole) {
  const Workshop shop;
  record_falling(shop, "a");
  const std::string engine =
      "'" TUMBLE_STREAM_ENGINE "' --stretched 4 --log '" + shop.path("stretched.tumblestream") + "'";
  ASSERT_EQ(std::system(engine.c_str()), 0);
  const Outcome told_stretched = shop.run({"import", "stretched.tumblestream"});
  EXPECT_EQ(told_stretched.exit, 0) << told_stretched.err;
  EXPECT_TRUE(says(told_stretched.err, "step 4: body 1: an orientation of length 2")) << told_stretched.err;
  write_falling(shop, "--open");
  const Outcome open = shop.run({"replay", "a.tumble"});
  EXPECT_TRUE(says(open.out, "its stream ends without the last frame")) << open.out << open.err;
  write_falling(shop, "--open --steps 30");
  const Outcome shorter = shop.run({"replay", "a.tumble"});
  EXPECT_EQ(shorter.exit, 1);
  EXPECT_TRUE(says(shorter.out, "different in length: the log ends with step 40, this run with step 30"))
      << shorter.out;
  shop.write("damage.sh", "'" TUMBLE_STREAM_ENGINE
                          "' --log \"$1\"\nprintf x | dd of=\"$1\" bs=1 seek=2000 conv=notrunc 2>/dev/null\n");
  shop.write("tumble.toml", "[engine]\nrun = 'sh damage.sh {log}'\n");
  const Outcome damaged = shop.run({"replay", "a.tumble"});
  EXPECT_EQ(damaged.exit, 3) << damaged.out << damaged.err;
  EXPECT_TRUE(says(damaged.err, "wrote a damaged stream")) << damaged.err;
}

TEST(EngineReplay, EnginesThatLieAreFound) {
  const Workshop shop;
  record_falling(shop, "a");
  const auto field = [&](const std::string& options) {
    write_falling(shop, options);
    const Outcome outcome = shop.run({"replay", "a.tumble", "--json"});
    EXPECT_EQ(outcome.exit, 1) << options << outcome.err;
    const ordered_json first = outcome.exit == 1 ? parsed(outcome)["first"] : ordered_json();
    return first.is_object() ? first["field"].get<std::string>() : "";
  };
  EXPECT_EQ(field("--nan 9"), "position.x");
  EXPECT_EQ(field("--dt 0.015"), "dt");
  EXPECT_EQ(field("--angle 9:0.5"), "channel.hinge.angle");
  EXPECT_EQ(field("--grip 9:0.25"), "channel.grip");
  write_falling(shop, "--extra");
  const Outcome extra = shop.run({"replay", "a.tumble"});
  EXPECT_EQ(extra.exit, 0) << extra.err;
  EXPECT_TRUE(says(extra.out, "only this run has channel extra, which the log cannot judge")) << extra.out;
  EXPECT_EQ(parsed(shop.run({"replay", "a.tumble", "--json"}))["only_in"]["b"][0], "channel extra");
  record_falling(shop, "b", "--extra");
  write_falling(shop);
  const Outcome lost = shop.run({"replay", "b.tumble"});
  EXPECT_EQ(lost.exit, 1) << lost.out << lost.err;
  EXPECT_TRUE(says(lost.out, "different in what was recorded: only the log has channel extra; the 40 steps of both"))
      << lost.out;
  shop.write("tumble.toml", "[engine]\nrun = 'mkdir {log}'\n");
  EXPECT_EQ(shop.run({"replay", "a.tumble"}).exit, 4);
  shop.write("tumble.toml", "[engine]\nrun = 'cp tumble.toml {log}'\n");
  EXPECT_EQ(shop.run({"replay", "a.tumble"}).exit, 4) << "what the engine wrote is its own failure";
}

TEST(EngineReplay, NamedInputsComeBack) {
  const Workshop shop;
  record_falling(shop, "a", "--kick 7:2:0.5 --kick 7:2:0.25 --kick 9:1:-1");
  write_falling(shop);
  const Outcome same = shop.run({"replay", "a.tumble"});
  EXPECT_EQ(same.exit, 0) << same.out << same.err;
  EXPECT_TRUE(says(same.out, "input.kick of a body")) << same.out;
  shop.write("tumble.toml", "[engine]\nrun = 'cp {inputs} inputs.txt; " + kFalling + "'\nshell = true\n");
  EXPECT_EQ(shop.run({"replay", "a.tumble"}).exit, 0);
  const std::string text = shop.read("inputs.txt");
  const std::string half = R"({"step":7,"kind":"input","name":"kick","id":2,"hex":"000000000000e03f"})";
  const std::string quarter = R"({"step":7,"kind":"input","name":"kick","id":2,"hex":"000000000000d03f"})";
  EXPECT_TRUE(says(text, half + '\n' + quarter)) << text;
  EXPECT_TRUE(says(text, R"({"step":9,"kind":"input","name":"kick","id":1,"hex":"000000000000f0bf"})")) << text;
}

}  // namespace
}  // namespace tumble::test
