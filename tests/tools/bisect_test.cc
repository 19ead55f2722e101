// `tumble bisect` finds the commit in a history of 64, without help, whatever the question; and narrows two logs.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/history.h"

namespace tumble::test {
namespace {

using nlohmann::ordered_json;

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

/// The commit of the plan was found, and what belongs to it is told.
ordered_json expect_found(const History& history, const HistoryPlan& plan, const Outcome& outcome) {
  EXPECT_EQ(outcome.exit, 1) << outcome.out << outcome.err;
  ordered_json json = ordered_json::parse(outcome.out, nullptr, false);
  if (!json.is_object()) return json;
  EXPECT_EQ(json["found"], true);
  EXPECT_EQ(json["commit"]["commit"], history.commit(plan.fault));
  EXPECT_EQ(json["commit"]["subject"], "solve: a harmless clean-up");
  EXPECT_EQ(json["commit"]["author_date"].get<std::string>().substr(0, 9), "2023-11-1");
  EXPECT_EQ(json["before"]["commit"], history.commit(plan.fault - 1));
  EXPECT_EQ(json["after"]["commit"], history.commit(plan.fault));
  EXPECT_LE(json["tested"].size(), 2 + 6 + 2 * plan.broken.size());
  return json;
}

/// The sessions before and after: what the planted velocity does.
void expect_the_drift(const ordered_json& json) {
  const ordered_json& first = json["sessions"]["first"];
  EXPECT_EQ(first["step"], 0);
  EXPECT_EQ(first["phase"], "start");
  EXPECT_EQ(first["body"], 1);
  EXPECT_EQ(first["field"], "velocity.x");
  EXPECT_EQ(first["expected"], 0.0);
  EXPECT_NEAR(first["actual"].get<double>(), 0.01, 1e-9);
  bool lateral_moved = false;
  for (const ordered_json& metric : json["sessions"]["aftermath"]["metrics"]) {
    lateral_moved = lateral_moved || (metric["name"] == "lateral_max" && metric["expected"] == 0.0);
  }
  EXPECT_TRUE(lateral_moved);
}

TEST(BisectCommand, FindsTheCommitByExactEqualityAndTouchesNothing) {
  const Workshop shop;
  const HistoryPlan plan;
  const History history(shop, plan);
  shop.write("project/notes.txt", "not committed yet\n");
  shop.write("project/mine.txt", "not known to git\n");
  const std::string before = history.footprint();
  const Outcome outcome = history.bisect({"session.tumble", "--json"});
  const ordered_json json = expect_found(history, plan, outcome);
  expect_the_drift(json);
  EXPECT_TRUE(history.footprint() == before) << "the clone has changed";
  EXPECT_FALSE(std::filesystem::exists(shop.path("work"))) << "the folder of work is still there";
  EXPECT_GE(count(outcome.err, "skip "), 1U) << "the plan puts what does not build in the middle";
}

TEST(BisectCommand, FindsTheCommitByAMetric) {
  const Workshop shop;
  const HistoryPlan plan;
  const History history(shop, plan);
  const ordered_json json =
      expect_found(history, plan, history.bisect({"session.tumble", "--metric", "lateral_max<=0", "--json"}));
  EXPECT_EQ(json["before"]["metric"], 0.0);
  EXPECT_GT(json["after"]["metric"], 0.003);
  expect_the_drift(json);
  const Outcome text = history.bisect({"session.tumble", "--metric", "lateral_max<=0"});
  EXPECT_EQ(text.exit, 1);
  for (const char* words :
       {"steps left|left, about", "solve: a harmless clean-up", "lateral_max is 0 m", "velocity.x"}) {
    const std::string wanted = std::string(words).substr(std::string(words).find('|') + 1);
    EXPECT_NE(text.out.find(wanted), std::string::npos) << wanted << "\n" << text.out;
  }
  EXPECT_EQ(text.out.find("about 0 steps"), std::string::npos) << text.out;
}

TEST(BisectCommand, FindsTheCommitByAnImage) {
  const Workshop shop;
  HistoryPlan plan;
  plan.with_case = true;
  const History history(shop, plan);
  const ordered_json json = expect_found(history, plan, history.bisect({"--case", "look", "--image", "--json"}));
  EXPECT_NE(json["question"].get<std::string>().find("image"), std::string::npos);
}

TEST(BisectCommand, AsksAnyEngineThatWritesLogs) {
  const Workshop shop;
  const HistoryPlan plan{.commits = 12, .fault = 5, .broken = {}};
  const History history(shop, plan);
  expect_found(history, plan,
               history.bisect({"session.tumble", "--run", "bin/tumble record {scene} -o {log} --quiet", "--json"}));
}

TEST(BisectCommand, ALogOfTheBadRevisionWillDoAsWell) {
  const Workshop shop;
  const HistoryPlan plan{.commits = 12, .fault = 9, .broken = {}};
  const History history(shop, plan);
  ASSERT_EQ(
      shop.run({"record", "scene.toml", "-o", "bad.tumble", "--quiet", "--set", "box.1.velocity=[0.01,0.0,0.0]"}).exit,
      0);
  expect_found(history, plan, history.bisect({"bad.tumble", "--json"}));
}

TEST(BisectAny, FindsTheCommitThroughGit) {
  const Workshop shop;
  const HistoryPlan plan{.commits = 16, .fault = 7, .broken = {8, 9}};
  const History history(shop, plan);
  const std::string script = std::string(TUMBLE_SOURCE_DIR) + "/tools/bisect-any.sh";
  const std::string judge = "--require 'lateral_max<=0' --log '" + shop.path("session.tumble") + "'";
  const std::string command =
      "cd '" + shop.path("project") + "' && { git bisect start main " + history.commit(1) +
      " && TUMBLE='" TUMBLE_PROGRAM "' git bisect run '" + script +
      "' --build 'sh build.sh' --run 'bin/tumble record scene.toml -o \"$TUMBLE_LOG\" --quiet' " + judge +
      " && git rev-parse refs/bisect/bad; } >'" + shop.path("found") + "' 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << shop.read("found");
  EXPECT_TRUE(shop.read("found").ends_with(history.commit(plan.fault) + "\n")) << shop.read("found");
}

constexpr const char* kBuildEngine = "cp engine.sh built.sh";

/// A clone "project" of an engine, whose second of three commits throws its body faster. Its golden case is blessed in
/// the first.
void make_engine_history(const Workshop& shop) {
  shop.write("project/golden/cases/fall/scene.toml", kSmallScene);
  shop.write(
      "project/golden/cases/fall/metrics.toml",
      "require = [\"behaviour\"]\n[command]\nrun = \"../built.sh {log} {scene}\"\n[[metric]]\nname = \"drift_max\"\n"
      "max = 2.5\nwhy = \"a test\"\n");
  const std::string commits =
      "cd '" + shop.path("project") +
      R"('
commit() {
  cat >engine.sh <<END
#!/bin/sh
{ echo "# engine: toy"; echo "# dt: 0.1"; echo "step,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z,\\
velocity.x,velocity.y,velocity.z,spin.x,spin.y,spin.z"
  for k in 0 1 2; do echo "\$k,1,\$((k * $1)),0,1,1,0,0,0,0,0,0,0,0,0"; done; } >"\$1.csv"
')" TUMBLE_PROGRAM R"(' import "\$1.csv" -o "\$1" --json >/dev/null
END
  chmod +x engine.sh && cp engine.sh built.sh && echo built.sh >.gitignore && git add -A && git -c user.name=a -c user.email=a@b commit --allow-empty -qm "speed $1: $2"
}
git init -q -b main && commit 1 first &&
  ')" TUMBLE_PROGRAM
      R"(' bless fall --suite golden --reason first >/dev/null && commit 1 blessed && commit 2 faster && commit 2 last)";
  ASSERT_EQ(std::system(("{ " + commits + "\n} >'" + shop.path("said") + "' 2>&1").c_str()), 0) << shop.read("said");
}

TEST(BisectCommand, AnEngineThatReadsNoScene) {
  const Workshop shop;
  make_engine_history(shop);
  const std::vector<std::string> search = {"bisect", "--repo", "project", "--good",
                                           "HEAD~2", "--bad",  "HEAD",    "--json"};
  const auto ask = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = search;
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = shop.run(words);
    EXPECT_EQ(outcome.exit, 1) << outcome.err;
    return ordered_json::parse(outcome.out);
  };
  const std::vector<std::string> of_case = {"--case", "fall", "--build", kBuildEngine, "--program", TUMBLE_PROGRAM};
  const ordered_json by_case = ask(of_case);
  EXPECT_EQ(by_case["commit"]["subject"], "speed 2: faster");
  EXPECT_EQ(by_case["sessions"]["first"]["field"], "position.x") << by_case["sessions"];
  for (int k = 0; k < 2; ++k) {  // a program that was kept is not all of such a build
    std::vector<std::string> with_cache = of_case;
    with_cache.insert(with_cache.end(), {"--cache", "kept"});
    EXPECT_EQ(ask(with_cache)["commit"], by_case["commit"]);
  }
  const std::string record_first =
      "cd '" + shop.path("project") +
      "' && git checkout -q HEAD~2 && ./engine.sh ../wanted.tumble && git checkout -q main";
  ASSERT_EQ(std::system(record_first.c_str()), 0);
  const ordered_json by_bits = ask({"wanted.tumble", "--run", "./engine.sh {log}"});
  EXPECT_EQ(by_bits["commit"]["subject"], "speed 2: faster");
  const Outcome sceneless = shop.run({"bisect", "--repo", "project", "--good", "HEAD~2", "--bad", "HEAD",
                                      "wanted.tumble", "--run", "./engine.sh {scene} {log}"});
  EXPECT_EQ(sceneless.exit, 2) << "a table has no scene";
}

TEST(BisectCommand, ShowsHowFarABuildIsOnATerminal) {
  const Workshop shop;
  const History history(shop, {.commits = 3, .fault = 2, .broken = {}});
  shop.write("slow.sh", "echo '[3/9] Building a.o'; sleep 1\n");
  const std::string bisect =
      TUMBLE_PROGRAM " bisect session.tumble --good " + history.commit(1) +
      " --bad main --repo project --work work --program bin/tumble --build 'sh build.sh' --build "
      "'sh " +
      shop.path("slow.sh") + "'";
  shop.write("bisect.sh", bisect + "\n");
  const std::string terminal =
      "cd '" + shop.path("") + "' && script -qec 'sh bisect.sh' /dev/null >shown 2>&1 </dev/null";
  EXPECT_NE(std::system(terminal.c_str()), 0) << "a commit was found: status 1";
  EXPECT_NE(shop.read("shown").find("building [3/9], 0 s so far"), std::string::npos) << shop.read("shown");
}

TEST(BisectCommand, GoesOnAfterAnInterruption) {
  const Workshop shop;
  const HistoryPlan plan{.commits = 20, .fault = 14, .broken = {}};
  const History history(shop, plan);
  const std::vector<std::string> question = {"session.tumble", "--metric", "lateral_max<=0", "--json"};
  std::vector<std::string> again = question;
  again.emplace_back("--resume");
  EXPECT_EQ(history.bisect(again).exit, 2) << "there is nothing to resume";
  history.interrupt_next();
  const Outcome stopped = history.bisect(question);
  EXPECT_EQ(stopped.exit, 4);
  EXPECT_NE(stopped.err.find("--resume"), std::string::npos) << stopped.err;
  const Outcome resumed = history.bisect(again);
  expect_found(history, plan, resumed);
}

TEST(BisectCommand, DoesNotAskAgainWhatItKnows) {
  const Workshop shop;
  const HistoryPlan plan{.commits = 20, .fault = 14, .broken = {}};
  const History history(shop, plan);
  const std::vector<std::string> question = {"session.tumble", "--json", "--keep"};
  const std::size_t all = count(history.bisect(question).err, "asking ");
  EXPECT_GE(all, 6U);
  std::vector<std::string> again = question;
  again.emplace_back("--resume");
  const Outcome resumed = history.bisect(again);
  expect_found(history, plan, resumed);
  EXPECT_EQ(count(resumed.err, "asking "), 0U) << resumed.err;
}

TEST(BisectCommand, NamesAllSuspectsWhereTheFaultDoesNotBuild) {
  const Workshop shop;
  const History history(shop, {.commits = 10, .fault = 6, .broken = {5, 6}});
  const Outcome outcome = history.bisect({"session.tumble", "--json"});
  EXPECT_EQ(outcome.exit, 4) << outcome.err;
  const ordered_json json = ordered_json::parse(outcome.out);
  EXPECT_EQ(json["found"], false);
  ASSERT_EQ(json["suspects"].size(), 3U);
  EXPECT_EQ(json["suspects"][2]["commit"], history.commit(7));
}

TEST(BisectCommand, SaysWhatIsWrongWithItsArguments) {
  const Workshop shop;
  const History history(shop, {.commits = 4, .fault = 3, .broken = {}});
  const auto says = [&](const std::vector<std::string>& arguments, const std::string& words) {
    std::vector<std::string> all = {"bisect", "--repo", "project", "--work", "work"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Outcome outcome = shop.run(all);
    EXPECT_EQ(outcome.exit, 2) << outcome.out << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  };
  const std::string first = history.commit(1);
  says({}, "wanted two logs");
  says({"--good", first}, "--bad");
  says({"--good", first, "--bad", "main"}, "wanted LOG");
  says({"--good", "nowhere", "--bad", "main", "session.tumble"}, "\"nowhere\"");
  says({"--good", "main", "--bad", first, "session.tumble"}, "ancestor");
  says({"--good", "main", "--bad", "main", "session.tumble"}, "same commit");
  says({"--good", first, "--bad", "main", "session.tumble", "--metric", "no_such<=0"}, "no_such");
  says({"--good", first, "--bad", "main", "session.tumble", "--image"}, "--case");
  says({"--good", first, "--bad", "main", "session.tumble", "--run", "engine"}, "{log}");
  says({"--good", first, "--bad", "main", "scene.toml"}, "not a log");
  const Outcome same = history.bisect({"session.tumble", "--metric", "lateral_max<=100"});
  EXPECT_EQ(same.exit, 2);
  EXPECT_NE(same.err.find("the same answer for both ends: both are within the bound"), std::string::npos) << same.err;
  const Outcome beyond = history.bisect({"session.tumble", "--metric", "lateral_max<=-1"});
  EXPECT_NE(beyond.err.find("for both ends: both are out of bound"), std::string::npos) << beyond.err;
  EXPECT_NE(beyond.out.find(" m, out of bound"), std::string::npos) << beyond.out;
  EXPECT_NE(same.err.find("the clone and the answers stay in"), std::string::npos) << same.err;
}

TEST(BisectCommand, ABoundThatJudgesNoStepOrNoBodyCannotBeAsked) {
  const Workshop shop;
  const History history(shop, {.commits = 4, .fault = 3, .broken = {}});
  const Outcome none = history.bisect({"session.tumble", "--metric", "drift_max<=0", "--from-step", "20"});
  EXPECT_EQ(none.exit, 4) << none.out;
  EXPECT_NE(none.err.find("no step to judge"), std::string::npos) << none.err;
  const Outcome spread = history.bisect({"session.tumble", "--metric", "column_spread<=0"});
  EXPECT_NE(spread.err.find("column_spread is no value: no body of a grid"), std::string::npos) << spread.err;
}

TEST(BisectCommand, NarrowsTwoLogs) {
  const Workshop shop;
  shop.record_small("a");
  shop.record_small("b", {"--set", "input.1.velocity=[0.0, 6.5, 0.0]"});
  EXPECT_EQ(shop.run({"bisect", "a.tumble", "a.tumble"}).exit, 0);
  const Outcome outcome = shop.run({"bisect", "a.tumble", "b.tumble", "--json"});
  EXPECT_EQ(outcome.exit, 1) << outcome.err;
  const ordered_json json = ordered_json::parse(outcome.out);
  EXPECT_EQ(json["first"]["step"], 5);
  EXPECT_EQ(json["narrowed"]["this_build_follows"], "both");
  EXPECT_LE(json["chunks_opened"], 4);
}

}  // namespace
}  // namespace tumble::test
