// `diff --zoom` runs two builds of an engine with probes and names the first line with another value.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/program.h"
#include "tests/support/source_tree.h"
#include "tests/tools/json_output.h"
#include "tests/tools/toy.h"

namespace tumble::test {
namespace {

using nlohmann::ordered_json;

ordered_json zoom(const Workshop& shop, const std::string& engine_a, const std::string& engine_b) {
  const Outcome outcome =
      shop.run({"diff", "a.tumble", "b.tumble", "--zoom", "--engine-a", engine_a, "--engine-b", engine_b, "--json"});
  EXPECT_EQ(outcome.exit, 1) << outcome.err;
  return parsed(outcome)["zoom"];
}

/// The line of tests/toy/toy_solver.cc that writes the probe behind line n of the toy engine.
std::size_t probe_line(int n) {
  const std::string mark = "line(" + std::to_string(n) + ",";
  for (const SourceFile& file : source_tree()) {
    if (file.path != "tests/toy/toy_solver.cc") continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      if (file.lines[i].find(mark) == std::string::npos) continue;
      while (file.lines[i].find("TUMBLE_PROBE") == std::string::npos) ++i;
      return i + 1;
    }
  }
  return 0;
}

std::string line_of(const std::string& path, std::size_t line) {
  for (const SourceFile& file : source_tree()) {
    if (file.path == path && line > 0 && line <= file.lines.size()) return file.lines[line - 1];
  }
  return "";
}

TEST(Zoom, NamesTheLineOfEachOfTenPlantedChanges) {
  const Workshop shop;
  record_toy(shop, "a.tumble");
  for (int n = 1; n <= 10; ++n) {
    const std::string fault = " --fault " + std::to_string(n);
    record_toy(shop, "b.tumble", fault);
    const ordered_json found = zoom(shop, kToy, kToy + fault);
    ASSERT_TRUE(found["first"].is_object()) << n << found;
    EXPECT_EQ(found["first"]["actual"]["line"], probe_line(n)) << n << found["first"];
    EXPECT_TRUE(found["first"]["actual"]["file"].get<std::string>().ends_with("tests/toy/toy_solver.cc"));
    EXPECT_EQ(found["strays"], ordered_json({"", ""}));
    for (const ordered_json& probe : found["same_before"]) EXPECT_FALSE(probe["name"].get<std::string>().empty());
  }
}

TEST(Zoom, MatchesPairsByKeyWhereTheirOrderDiffers) {
  const Workshop shop;
  record_toy(shop, "a.tumble");
  record_toy(shop, "b.tumble", "--reverse --fault 3");
  const ordered_json found = zoom(shop, kToy, kToy + " --reverse --fault 3");
  EXPECT_EQ(found["first"]["expected"]["name"], "toy.mass");
  EXPECT_EQ(found["first"]["expected"]["key"], found["first"]["actual"]["key"]);
  EXPECT_TRUE(found["reordered"].is_object()) << "the order of the pairs is another one, and that is said";
  EXPECT_EQ(found["only_a"]["count"], 0) << found["only_a"];
}

TEST(Zoom, TextNamesPlaceValuesAndWhatWasTheSameBefore) {
  const Workshop shop;
  record_toy(shop, "a.tumble");
  record_toy(shop, "b.tumble", "--fault 6");
  shop.write("old/tumble.toml", "[engine]\nrun = '" + kToy + "'\n");
  shop.write("tumble.toml", "[engine]\nrun = '" + kToy + " --fault 6'\n");
  const Outcome outcome = shop.run({"diff", "a.tumble", "b.tumble", "--zoom", "--engine-a", "old"});
  EXPECT_EQ(outcome.exit, 1) << outcome.err;
  for (const char* words : {"zoom into step 1", "first probe that differs", "toy.lambda, key 0 and 1",
                            "toy_solver.cc:", "ulps apart", "the same just before", "toy.relative, key 0 and 1"}) {
    EXPECT_TRUE(says(outcome.out, words)) << words << '\n' << outcome.out;
  }
}

TEST(Zoom, SaysWhereAnEngineDoesNotRepeatItsLogAndWhereThereAreNoProbes) {
  const Workshop shop;
  record_toy(shop, "a.tumble");
  record_toy(shop, "b.tumble", "--fault 6");
  const ordered_json astray = zoom(shop, kToy, kToy);
  EXPECT_TRUE(says(astray["strays"][1].get<std::string>(), "step 1")) << astray["strays"];
  EXPECT_EQ(astray["first"], nullptr) << "one build twice";
  const std::string silent = "env -u TUMBLE_PROBE_FILE " + kToy;
  const Outcome none =
      shop.run({"diff", "a.tumble", "b.tumble", "--zoom", "--engine-a", silent, "--engine-b", kToy + " --fault 6"});
  EXPECT_EQ(none.exit, 2);
  EXPECT_TRUE(says(none.err, "wrote no probes")) << none.err;
  const Outcome wrong = shop.run({"diff", "a.tumble", "b.tumble", "--zoom", "--engine-a", "no/such/place"});
  EXPECT_EQ(wrong.exit, 2);
  EXPECT_TRUE(says(wrong.err, "--engine-a: found \"no/such/place\", wanted")) << wrong.err;
  EXPECT_EQ(shop.run({"diff", "a.tumble", "b.tumble", "--engine-a", "x"}).exit, 2) << "without --zoom";
}

TEST(Zoom, TwoSessionsOfOurOwnEngineToThePhase) {
  const Workshop shop;
  shop.record_small("a");
  shop.record_small("b", {"--set", "world.gravity=[0, 0, -9.811]"});
  const Outcome outcome = shop.run({"diff", "a.tumble", "b.tumble", "--zoom", "--json"});
  EXPECT_EQ(outcome.exit, 1) << outcome.err;
  const ordered_json found = parsed(outcome)["zoom"];
  const ordered_json& first = found["first"]["expected"];
  EXPECT_EQ(first["file"], "src/kernels/body_kernels_impl.h") << "the statement, not the function of the phase";
  EXPECT_EQ(first["name"], "integrate: position.z");
  EXPECT_EQ(line_of("src/kernels/body_kernels_impl.h", first["line"]),
            "  store_space(b.position, at, chosen(flies, there, position));");
  EXPECT_EQ(found["only_a"]["count"], 0);
}

// Another friction is the first difference where the body is thrown; it computes another value only where it slides.
TEST(Zoom, BehindInputsThatDifferItTakesTheFirstStepComputedOtherwise) {
  const Workshop shop;
  shop.record_small("a");
  shop.record_small("b", {"--set", "material.friction=0.4000001"});
  const Outcome outcome = shop.run({"diff", "a.tumble", "b.tumble", "--zoom", "--json"});
  EXPECT_EQ(outcome.exit, 1) << outcome.err;
  const ordered_json json = parsed(outcome);
  ASSERT_EQ(json["first"]["phase"], "inputs") << json["first"];
  EXPECT_GT(json["zoom"]["step"], json["first"]["step"]);
  EXPECT_LE(json["zoom"]["step"], json["effect"]["step"]);
  EXPECT_TRUE(json["zoom"]["first"].is_object()) << "a probe differs in the step that was computed otherwise";
  const Outcome text = shop.run({"diff", "a.tumble", "b.tumble", "--zoom"});
  EXPECT_TRUE(says(text.out, ", the first whose state or phases have another hash: ")) << text.out;
}

// Method thesis finds contacts in each substep: of the pairs of a substep that has none yet there is no depth to write.
TEST(Zoom, TakesAStepOfMethodThesisInWhichContactsBegin) {
  const Workshop shop;
  ASSERT_EQ(shop.run({"record", "brick_wall", "-o", "a.tumble", "--steps", "46", "--quiet"}).exit, 0);
  for (int step = 40; step <= 46; ++step) {  // the thrown cube meets the wall within step 45
    const Outcome outcome =
        shop.run({"replay", "a.tumble", "--probes", "probes", "--probe-step", std::to_string(step)});
    ASSERT_EQ(outcome.exit, 0) << "step " << step << ": " << outcome.err;
  }
}

TEST(Groups, NameTheOddLogOfMany) {
  const Workshop shop;
  for (const char* name : {"a.tumble", "b.tumble", "d.tumble"}) record_toy(shop, name);
  record_toy(shop, "c.tumble", "--fault 10");
  const Outcome text = shop.run({"diff", "a.tumble", "b.tumble", "c.tumble", "d.tumble"});
  EXPECT_EQ(text.exit, 1) << text.err;
  EXPECT_TRUE(says(text.out, "different: 4 logs in 2 groups")) << text.out;
  EXPECT_TRUE(says(text.out, "agree    a.tumble, b.tumble, d.tumble")) << text.out;
  EXPECT_TRUE(says(text.out, "odd      c.tumble: different from step 10 on")) << text.out;
  EXPECT_TRUE(says(text.out, "c.tumble against a.tumble")) << text.out;
  const ordered_json json = parsed(shop.run({"diff", "c.tumble", "a.tumble", "b.tumble", "d.tumble", "--json"}));
  EXPECT_EQ(json["identical"], false);
  EXPECT_EQ(json["has_majority"], true);
  EXPECT_EQ(json["groups"][1]["logs"], ordered_json({"c.tumble"}));
  EXPECT_EQ(json["groups"][1]["first"]["field"], "position.x");
  const Outcome same = shop.run({"diff", "a.tumble", "b.tumble", "d.tumble"});
  EXPECT_EQ(same.exit, 0) << same.out;
  EXPECT_TRUE(says(same.out, "identical: 3 logs")) << same.out;
  record_toy(shop, "e.tumble", "--fault 10");
  const ordered_json even = parsed(shop.run({"diff", "a.tumble", "b.tumble", "c.tumble", "e.tumble", "--json"}));
  EXPECT_EQ(even["has_majority"], false);
  EXPECT_EQ(even["groups"][1]["odd"], false) << "two against two: nobody is odd";
  record_toy(shop, "short.tumble", "--steps 5");
  const Outcome shorter = shop.run({"diff", "a.tumble", "b.tumble", "c.tumble", "short.tumble", "--json"});
  EXPECT_EQ(shorter.exit, 1);
  EXPECT_EQ(parsed(shorter)["undecided"], ordered_json({"short.tumble"})) << shorter.out;
}

// c and d have no channel, so they agree with both a and b, which differ in theirs: they decide nothing.
TEST(Groups, ALogWithoutAChannelDecidesNothing) {
  const Workshop shop;
  const auto import = [&](const std::string& name, const std::string& head, const std::string& cell,
                          const std::string& more = "") {
    const std::string columns =
        "step,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z";
    shop.write(name + ".csv", "# engine: mine\n# dt: 0.1\n" + columns + head + "\n0,1,0,0,1,1,0,0,0" + cell +
                                  "\n1,1,0,0,1,1,0,0,0" + cell + "\n" + more);
    const Outcome outcome = shop.run({"import", name + ".csv", "-o", name + ".tumble"});
    ASSERT_EQ(outcome.exit, 0) << outcome.err;
  };
  import("a", ",channel.hinge", ",0.5");
  import("b", ",channel.hinge", ",0.25");
  import("c", "", "");
  import("d", "", "", "2,1,0,0,1,1,0,0,0\n");  // the longest, so that it stands for its group
  for (const std::vector<std::string>& order : {std::vector<std::string>{"c.tumble", "a.tumble", "b.tumble"},
                                                std::vector<std::string>{"a.tumble", "c.tumble", "b.tumble"},
                                                std::vector<std::string>{"b.tumble", "a.tumble", "c.tumble"}}) {
    const Outcome outcome = shop.run({"diff", order[0], order[1], order[2], "--json"});
    EXPECT_EQ(outcome.exit, 1) << outcome.out << outcome.err;
    const ordered_json json = parsed(outcome);
    EXPECT_EQ(json["groups"].size(), 2U) << json;
    EXPECT_EQ(json["has_majority"], false) << json;
    EXPECT_EQ(json["undecided"], ordered_json({"c.tumble"})) << json;
  }
  const Outcome longer = shop.run({"diff", "d.tumble", "a.tumble", "b.tumble", "--json"});
  EXPECT_EQ(parsed(longer)["groups"].size(), 2U) << longer.out;
  EXPECT_EQ(parsed(longer)["undecided"], ordered_json({"d.tumble"})) << longer.out;
  const Outcome excused = shop.run({"diff", "a.tumble", "c.tumble", "--tolerance", "hinge=1"});
  EXPECT_EQ(excused.exit, 2) << excused.out;
  EXPECT_TRUE(says(excused.err, "found no such channel of numbers in c.tumble")) << excused.err;
}

// One odd cell makes a table's channel text; values of other kinds are never equal.
TEST(Kinds, OneOddCellIsADifference) {
  const Workshop shop;
  for (const char* cell : {"0.5", "N/A"}) {
    const std::string name = cell[0] == 'N' ? "odd" : "plain";
    shop.write(name + ".csv", std::string("# engine: mine\n# dt: 0.1\nstep,id,position.x,position.y,position.z,"
                                          "orientation.w,orientation.x,orientation.y,orientation.z,channel.hinge\n") +
                                  "0,1,0,0,1,1,0,0,0,0.5\n1,1,0,0,1,1,0,0,0," + cell + "\n");
    ASSERT_EQ(shop.run({"import", name + ".csv", "-o", name + ".tumble"}).exit, 0);
  }
  const Outcome outcome = shop.run({"diff", "plain.tumble", "odd.tumble"});
  EXPECT_EQ(outcome.exit, 1) << outcome.out << outcome.err;
  EXPECT_TRUE(says(outcome.out, "channel.hinge")) << outcome.out;
  EXPECT_TRUE(says(outcome.out, "text of scope body")) << outcome.out;
}

TEST(Groups, TakeNoOptionOfTwoLogs) {
  const Workshop shop;
  record_toy(shop, "a.tumble");
  for (const std::vector<std::string>& option : {std::vector<std::string>{"--until", "1"},
                                                 {"--apart", "1"},
                                                 {"--tolerance", "position=1"},
                                                 {"--plot", "p.svg"},
                                                 {"--brief"}}) {
    std::vector<std::string> words = {"diff", "a.tumble", "a.tumble", "a.tumble"};
    words.insert(words.end(), option.begin(), option.end());
    const Outcome outcome = shop.run(words);
    EXPECT_EQ(outcome.exit, 2) << option[0] << outcome.out;
    EXPECT_TRUE(says(outcome.err, "found an option that takes two logs")) << outcome.err;
  }
}

TEST(Until, NothingToCompareIsNoAnswer) {
  const Workshop shop;
  record_toy(shop, "a.tumble");
  EXPECT_EQ(shop.run({"diff", "a.tumble", "a.tumble", "--until", "1e-6"}).exit, 2);
  for (const char* id : {"1", "2"}) {
    shop.write(std::string(id) + ".csv",
               std::string("# engine: mine\n# dt: 0.1\nstep,id,position.x,position.y,position.z,"
                           "orientation.w,orientation.x,orientation.y,orientation.z\n") +
                   "0," + id + ",0,0,1,1,0,0,0\n1," + id + ",0,0,1,1,0,0,0\n");
    ASSERT_EQ(shop.run({"import", std::string(id) + ".csv", "-o", std::string(id) + ".tumble"}).exit, 0);
  }
  const Outcome apart = shop.run({"diff", "1.tumble", "2.tumble", "--apart", "0.01"});
  EXPECT_EQ(apart.exit, 1) << "no body is in both";
  EXPECT_TRUE(says(apart.out, "of the bodies that both have; others exist in one only")) << apart.out;
}

TEST(Until, EndsTheComparisonAndTellsWhenTheSessionsPart) {
  const Workshop shop;
  record_toy(shop, "a.tumble");
  record_toy(shop, "b.tumble", "--fault 10");
  const Outcome before = shop.run({"diff", "a.tumble", "b.tumble", "--until", "0.140625", "--json"});
  EXPECT_EQ(before.exit, 0) << before.out;
  EXPECT_EQ(parsed(before)["steps"], 9) << "9 of 1/64 s";
  EXPECT_TRUE(says(before.out, "all behind step 9, as asked")) << before.out;
  EXPECT_EQ(shop.run({"diff", "a.tumble", "b.tumble", "--until", "0.16"}).exit, 1);
  const Outcome near = shop.run({"diff", "a.tumble", "b.tumble", "--apart", "0.001", "--json"});
  EXPECT_EQ(near.exit, 0) << "bits differ, but no body is that far off";
  EXPECT_EQ(parsed(near)["apart"]["time"], nullptr);
  const Outcome apart = shop.run({"diff", "a.tumble", "b.tumble", "--apart", "1e-12", "--json"});
  EXPECT_EQ(apart.exit, 1);
  EXPECT_EQ(parsed(apart)["apart"]["step"], 10);
  EXPECT_DOUBLE_EQ(parsed(apart)["apart"]["time"].get<double>(), 10.0 / 64);
}

}  // namespace
}  // namespace tumble::test
