// Channels of an engine in plots, tables, metrics, cases and bisections; and the time at which two sessions part.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/program.h"
#include "tests/tools/engine_table.h"
#include "tests/tools/json_output.h"
#include "tests/tools/stream_toy.h"

namespace tumble::test {
namespace {

using nlohmann::ordered_json;

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

TEST(EngineChannels, AreColumnsOfSeriesAndPanelsOfPlots) {
  const Workshop shop;
  record_falling(shop, "a", "--table");
  record_falling(shop, "b", "--table --angle 9:0.5");
  ASSERT_EQ(shop.run({"measure", "a.tumble", "--series", "a.csv"}).exit, 0);
  const std::string series = shop.read("a.csv");
  EXPECT_TRUE(
      first_line(series).ends_with(",channel.hinge.angle.min (rad),channel.hinge.angle.max "
                                   "(rad),channel.hinge.angle.mean (rad),channel.random.seed"))
      << first_line(series);
  EXPECT_TRUE(says(series, ",0.5,1,0.75,113\n")) << "the angles after 16 steps of 1/64 s are 0.5 and 1";
  const Outcome diff = shop.run({"diff", "a.tumble", "b.tumble"});
  EXPECT_EQ(diff.exit, 1);
  EXPECT_TRUE(says(diff.out, "channel hinge.angle")) << diff.out;
  EXPECT_TRUE(says(diff.out, "differs from step 9 on, by up to 0.25 rad (step 9)")) << diff.out;
  EXPECT_TRUE(says(diff.out, "channel.hinge.angle.change_max")) << "a metric that moved\n" << diff.out;
  const ordered_json json = parsed(shop.run({"diff", "a.tumble", "b.tumble", "--json"}));
  EXPECT_EQ(json["aftermath"]["channels"][0]["name"], "hinge.angle");
  EXPECT_EQ(json["aftermath"]["channels"][0]["largest"], 0.25);
  if (std::system("gnuplot --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no gnuplot";
  ASSERT_EQ(shop.run({"measure", "a.tumble", "--plot", "a.svg"}).exit, 0);
  EXPECT_TRUE(says(shop.read("a.svg"), "channel hinge.angle, rad"));
  EXPECT_TRUE(says(shop.read("a.svg"), "channel random.seed"));
  EXPECT_EQ(shop.run({"diff", "a.tumble", "b.tumble", "--plot", "d.svg"}).exit, 1);
  EXPECT_TRUE(says(shop.read("d.svg"), "channel hinge.angle, apart, rad"));
}

TEST(EngineChannels, OfPairsAndUnitsStandInTablesAndComeBack) {
  const Workshop shop;
  record_falling(shop, "a", "--grip 9:0.25");
  const Outcome table = shop.run({"dump", "a.tumble", "--steps", "0:40", "--csv"});
  ASSERT_EQ(table.exit, 0) << table.err;
  EXPECT_TRUE(first_line(table.out).ends_with(",pair.grip,channel.hinge.angle,world.random.seed") ||
              says(first_line(table.out), ",pair.grip"))
      << first_line(table.out);
  EXPECT_TRUE(says(table.out, ",2=0.25,")) << table.out;
  shop.write("again.csv", "# engine: falling\n# dt: 0.015625\n# ground: no\n" + table.out);
  const Outcome imported = shop.run({"import", "again.csv"});
  ASSERT_EQ(imported.exit, 0) << imported.err;
  const Outcome same = shop.run({"diff", "a.tumble", "again.tumble"});
  EXPECT_EQ(same.exit, 0) << same.out;
  EXPECT_TRUE(says(same.out, "3 channels (grip, hinge.angle, random.seed)")) << same.out;
  record_falling(shop, "t", "--table");
  EXPECT_TRUE(
      says(first_line(shop.run({"dump", "t.tumble", "--steps", "0:3", "--csv"}).out), "channel.hinge.angle (rad)"));
  EXPECT_TRUE(says(shop.run({"info", "t.tumble"}).out, "hinge.angle")) << "the unit is none of the name's";
  shop.write(
      "bad.csv",
      "# dt: 1\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z,"
      "pair.grip\n0,1,0,0,0,1,0,0,0,2:5\n1,1,0,0,0,1,0,0,0,2=5\n");
  const Outcome wrong = shop.run({"import", "bad.csv"});
  EXPECT_EQ(wrong.exit, 2);
  EXPECT_TRUE(says(wrong.err, "bad.csv:3:") && says(wrong.err, "as in 7=0.25 9=0.5")) << wrong.err;
}

void write_case(const Workshop& shop, const std::string& metrics = "") {
  shop.write("golden/cases/fall/level.txt", "two boxes\n");
  shop.write("golden/cases/fall/metrics.toml",
             "[engine]\nfiles = [\"level.txt\"]\n[[metric]]\nname = \"channel.hinge.angle.max\"\nmax = 2\nwhy = \"the "
             "hinge has a stop\"\n" +
                 metrics);
}

TEST(EngineCaseChannels, ACaseWhoseOnlyDifferenceIsAChannelFailsAndNamesIt) {
  const Workshop shop;
  write_case(shop);
  write_falling(shop);
  const Outcome blessed = shop.run({"bless", "fall", "--reason", "a test"});
  ASSERT_EQ(blessed.exit, 0) << blessed.err;
  const Outcome passed = shop.run({"check", "--json"});
  EXPECT_EQ(passed.exit, 0) << passed.out;
  EXPECT_TRUE(says(parsed(passed)["cases"][0]["verdicts"]["exact"]["words"],
                   "same bits in all 41 states, 3 channels (grip, hinge.angle, random.seed)"))
      << passed.out;
  const auto fails = [&](const std::string& options, const std::string& field, const std::string& detail,
                         std::uint64_t step) {
    write_falling(shop, options);
    const Outcome outcome = shop.run({"check", "--json", "--report", "r"});
    EXPECT_EQ(outcome.exit, 1) << options << outcome.out;
    const ordered_json one = parsed(outcome)["cases"][0];
    const ordered_json& difference = one["difference"];
    EXPECT_EQ(difference["phase"], field) << one;
    EXPECT_EQ(difference["step"], step);
    EXPECT_TRUE(says(difference["words"], field + "; all states agree")) << difference;
    EXPECT_TRUE(says(difference["details"].dump(), detail)) << difference;
    EXPECT_TRUE(says(one["summary"], field + " moved from step")) << one["summary"];
  };
  fails("--angle 12:0.25", "channel.hinge.angle",
        "at step 12, channel.hinge.angle of body 2: expected 0.8660254037844386, actual 0.25", 12);
  fails("--seed 3:5", "channel.random.seed", "at step 3, channel.random.seed: expected 22, actual 5", 3);
  fails("--grip 4:0.75", "channel.grip", "of the pair 1 and 2: expected 0.5, actual 0.75", 4);
  fails("--extra", "channel.extra", "the golden has no such channel", 1);
  write_falling(shop, "--angle 12:2.5");
  const Outcome bound = shop.run({"check", "--report", "r"});
  EXPECT_EQ(bound.exit, 1);
  EXPECT_TRUE(says(bound.out, "channel.hinge.angle.max")) << "the bound is broken too\n" << bound.out;
}

TEST(EngineCaseChannels, AChannelThatIsGoneFailsWhateverIsRequired) {
  const Workshop shop;
  write_case(shop);
  write_falling(shop, "--extra");
  ASSERT_EQ(shop.run({"bless", "fall", "--reason", "a test"}).exit, 0);
  EXPECT_EQ(shop.run({"check", "--require", "behaviour"}).exit, 0);
  write_falling(shop);
  const Outcome gone = shop.run({"check", "--require", "behaviour", "--report", "r"});
  EXPECT_EQ(gone.exit, 1) << gone.out;
  EXPECT_TRUE(says(gone.out, "channel.extra: the session has no such channel; bless the case if that is meant"))
      << gone.out;
}

TEST(EngineCaseChannels, AChannelOfAnotherTypeFailsWhateverIsRequired) {
  const Workshop shop;
  const auto write_session = [&shop](const std::string& cell) {
    shop.write("now.csv",
               "# engine: mine\n# dt: 0.1\nstep,id,position.x,position.y,position.z,orientation.w,"
               "orientation.x,orientation.y,orientation.z,channel.hinge\n0,1,0,0,1,1,0,0,0,0.5\n"
               "1,1,0,0,1,1,0,0,0," +
                   cell + "\n");
  };
  shop.write("tumble.toml", "[engine]\nrun = 'cp now.csv {log}'\n");
  shop.write("golden/cases/fall/level.txt", "one box\n");
  shop.write("golden/cases/fall/metrics.toml",
             "[engine]\nfiles = [\"level.txt\"]\n[[metric]]\nname = \"lateral_max\"\nmax = 5\nwhy = \"a test\"\n");
  write_session("0.25");
  const Outcome blessed = shop.run({"bless", "fall", "--reason", "a test"});
  ASSERT_EQ(blessed.exit, 0) << blessed.err;
  EXPECT_EQ(shop.run({"check", "--require", "behaviour"}).exit, 0);
  write_session("N/A");
  const Outcome other = shop.run({"check", "--require", "behaviour", "--report", "r"});
  EXPECT_EQ(other.exit, 1) << other.out;
  EXPECT_TRUE(says(other.out, "channel.hinge: expected float64 of scope body, actual text of scope body; bless"))
      << other.out;
}

TEST(EngineCaseChannels, TheLineThatReproducesLeavesALogOfATableToo) {
  for (const std::string options : {"--angle 12:0.25", "--table --angle 12:0.25"}) {
    const Workshop shop;
    write_case(shop);
    write_falling(shop, options.starts_with("--table") ? "--table" : "");
    ASSERT_EQ(shop.run({"bless", "fall", "--reason", "a test"}).exit, 0);
    write_falling(shop, options);
    const Outcome failed = shop.run({"check", "--json", "--report", "r"});
    ASSERT_EQ(failed.exit, 1) << failed.out;
    const std::string line = parsed(failed)["cases"][0]["reproduce"];
    const std::string tumble = std::filesystem::path(TUMBLE_PROGRAM).parent_path().string();
    std::string script = "cd '" + shop.path("") + "' && PATH='";
    script.append(tumble).append("':\"$PATH\"\n").append(line).append(1, '\n');
    shop.write("line.sh", script);
    EXPECT_EQ(std::system(("sh '" + shop.path("line.sh") + "' >/dev/null").c_str()), 0) << line;
    EXPECT_EQ(shop.run({"diff", "fall.tumble", "r/cases/fall/actual.tumble"}).exit, 0) << line;
  }
}

TEST(EngineCaseChannels, TheTimeUntilTwoSessionsPartIsAMetric) {
  const Workshop shop;
  record_falling(shop, "a");
  record_falling(shop, "b", "--move 16:0.125");
  const Outcome measured = shop.run({"measure", "b.tumble", "--against", "a.tumble", "--json"});
  ASSERT_EQ(measured.exit, 0) << measured.err;
  EXPECT_EQ(parsed(measured)["partings"][0]["time"], 0.25) << "16 steps of 1/64 s";
  EXPECT_EQ(parsed(measured)["partings"][0]["step"], 16);
  const std::string require = "parting_time.0.1>=0.5";
  const Outcome early = shop.run({"measure", "b.tumble", "--against", "a.tumble", "--require", require});
  EXPECT_EQ(early.exit, 1);
  EXPECT_TRUE(says(early.err, "found 0.25 s")) << early.err;
  EXPECT_EQ(shop.run({"measure", "a.tumble", "--against", "a.tumble", "--require", require}).exit, 0);
  EXPECT_EQ(shop.run({"measure", "b.tumble", "--require", require}).exit, 2) << "against what?";
  EXPECT_EQ(shop.run({"measure", "b.tumble", "--require", "parting_time.-1>=0"}).exit, 2);

  std::system(("mkdir -p '" + shop.path("golden/cases/fall") + "' && cp '" + shop.path("a.tumble") + "' '" +
               shop.path("golden/cases/fall/reference.tumble") + "'")
                  .c_str());
  write_case(shop,
             "[[metric]]\nname = \"parting_time.0.1\"\nagainst = \"reference.tumble\"\nmin = 0.5\nwhy = \"near the "
             "reference for half a second\"\n");
  write_falling(shop);
  const Outcome blessed = shop.run({"bless", "fall", "--reason", "a test"});
  ASSERT_EQ(blessed.exit, 0) << blessed.err;
  EXPECT_EQ(shop.run({"check"}).exit, 0);
  write_falling(shop, "--move 16:0.125");
  const Outcome parted = shop.run({"check", "--json", "--report", "r"});
  EXPECT_EQ(parted.exit, 1);
  const ordered_json metric = parsed(parted)["cases"][0]["metrics"][1];
  EXPECT_EQ(metric["name"], "parting_time.0.1");
  EXPECT_EQ(metric["value"], 0.25);
  EXPECT_EQ(metric["pass"], false);
  write_case(shop, "[[metric]]\nname = \"parting_time.0.1\"\nmin = 0.5\nwhy = \"a test\"\n");
  EXPECT_TRUE(says(shop.run({"check", "--report", "r"}).out, "key \"against\": found nothing, wanted the log") ||
              says(shop.run({"check", "--report", "r"}).out, "\"against\""));
}

/// A clone whose engine is a script; the third of four commits changes its options.
void make_history(const Workshop& shop, const std::string& changed) {
  const std::string commits = "cd '" + shop.path("project") + R"('
commit() {
  printf '#!/bin/sh\nexec '"'"')" TUMBLE_STREAM_ENGINE R"('"'"' "$@" %s\n' "$1" >engine.sh
  chmod +x engine.sh
  git add -A && git -c user.name=a -c user.email=a@b commit --allow-empty -qm "$2"
}
git init -q -b main && commit "" first && commit "" second && commit ")" +
                              changed + R"(" faulty && commit ")" + changed + R"( " last)";
  shop.write("project/tumble.toml", "[engine]\nrun = './engine.sh --log {log} --inputs {inputs}'\n");
  ASSERT_EQ(std::system(("{ " + commits + "\n} >'" + shop.path("said") + "' 2>&1").c_str()), 0) << shop.read("said");
}

TEST(EngineBisect, AsksForABoundOnAChannelAndForTheTimeOfParting) {
  const Workshop shop;
  make_history(shop, "--angle 16:3 --move 32:0.5");
  record_falling(shop, "a");
  const auto subject = [&](const std::string& metric) {
    const Outcome found = shop.run(
        {"bisect", "--repo", "project", "--good", "HEAD~3", "--bad", "HEAD", "a.tumble", "--metric", metric, "--json"});
    EXPECT_EQ(found.exit, 1) << found.err;
    return found.exit == 1 ? parsed(found) : ordered_json();
  };
  const ordered_json angle = subject("channel.hinge.angle.max<=2");
  EXPECT_EQ(angle["commit"]["subject"], "faulty") << angle;
  EXPECT_EQ(angle["after"]["metric"], 3.0);
  const ordered_json parting = subject("parting_time.0.1>=0.6");
  EXPECT_EQ(parting["commit"]["subject"], "faulty") << parting;
  EXPECT_EQ(parting["after"]["metric"], 0.5) << "32 steps of 1/64 s";
}

// Its golden has a hash of contacts a step, which fit into the reader's slack up to 128 steps.
TEST(EngineChannels, AGoldenOfManyStepsIsReadBack) {
  const Workshop shop;
  write_falling(shop, "--steps 300");
  shop.write("golden/cases/fall/scene.txt", "two boxes\n");
  shop.write("golden/cases/fall/metrics.toml",
             "require = [\"exact\"]\n[engine]\ncategory = \"fall\"\nscene = \"scene.txt\"\n[[metric]]\nname = "
             "\"lost\"\nmax = 0\nwhy = \"they stay\"\n");
  const Outcome blessed = shop.run({"bless", "fall", "--suite", "golden", "--reason", "a test"});
  ASSERT_EQ(blessed.exit, 0) << blessed.err;
  const Outcome checked = shop.run({"check", "--suite", "golden", "--report", "r"});
  EXPECT_EQ(checked.exit, 0) << checked.out;
}

// A number that is none is neither the least nor the largest of the runs, wherever sorting leaves it.
TEST(EngineChannels, ThatAreNoNumberInOneOfManyRunsFailTheirBound) {
  const Workshop shop;
  std::string text = table();
  text.replace(text.find("frozen"), 6, "frozen,world.knee");
  for (std::size_t at = text.find("\n0,"); (at = text.find('\n', at + 1)) != std::string::npos; at += 6) {
    text.insert(at, ",@knee");
  }
  shop.write("table.in", text);
  shop.write("engine.sh",
             "n=$(cat count 2>/dev/null || echo 0); echo $(((n + 1) % 5)) >count\n"
             "knee=1.$n; [ -f odd ] && [ $n = 1 ] && knee=nan\nsed \"s/@knee/$knee/\" table.in >\"$1\"\n");
  shop.write("tumble.toml", "[engine]\nrun = \"sh engine.sh {log}\"\n");
  shop.write("golden/cases/knee/setup.txt", "bent");
  shop.write("golden/cases/knee/metrics.toml",
             "require = [\"behaviour\"]\n[engine]\nfiles = [\"setup.txt\"]\nrepeat = 5\n[[metric]]\n"
             "name = \"channel.knee.last\"\nmax = 2.0\nwhy = \"it bends no further\"\n");
  const Outcome blessed = shop.run({"bless", "knee", "--reason", "a test"});
  ASSERT_EQ(blessed.exit, 0) << blessed.err;
  ASSERT_EQ(shop.run({"check", "--report", "r"}).exit, 0);
  shop.write("odd", "");
  const Outcome odd = shop.run({"check", "--report", "r"});
  EXPECT_EQ(odd.exit, 1) << odd.out;
  EXPECT_TRUE(says(odd.out, "channel.knee.last") && says(odd.out, "in one of 5 runs: not a number")) << odd.out;
}

}  // namespace
}  // namespace tumble::test
