// `tumble bisect` at scale: several revisions at once, builds that are kept, a good end that is looked for, answers
// that change from time to time.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/history.h"
#include "tools/bisect/revision.h"

namespace tumble::test {
namespace {

using nlohmann::ordered_json;
using tools::bisect::Answer;
using tools::bisect::answer_of;

const std::vector<std::string> kQuestion = {"session.tumble", "--metric", "lateral_max<=0", "--json"};

std::vector<std::string> with(std::vector<std::string> more) {
  more.insert(more.end(), kQuestion.begin(), kQuestion.end());
  return more;
}

ordered_json found(const History& history, const HistoryPlan& plan, const Outcome& outcome) {
  EXPECT_EQ(outcome.exit, 1) << outcome.out << outcome.err;
  ordered_json json = ordered_json::parse(outcome.out, nullptr, false);
  EXPECT_EQ(json.value("commit", ordered_json()).value("commit", ""), history.commit(plan.fault));
  return json;
}

std::vector<std::string> tested(const ordered_json& json) {
  std::vector<std::string> commits;
  for (const ordered_json& one : json["tested"]) commits.push_back(one["commit"]);
  return commits;
}

std::ptrdiff_t builds(const Workshop& shop) {
  const std::string text = std::filesystem::exists(shop.path("builds")) ? shop.read("builds") : "";
  return std::ranges::count(text, '\n');
}

TEST(BisectScale, AsksSeveralAtOnceAndDecidesAlike) {
  const Workshop shop;
  const HistoryPlan plan{.commits = 40, .fault = 27, .broken = {19, 20, 21}};
  const History history(shop, plan);
  const ordered_json one = found(history, plan, history.bisect(with({"--jobs", "1"})));
  const std::ptrdiff_t needed = builds(shop);
  const ordered_json three = found(history, plan, history.bisect(with({"--jobs", "3"})));
  EXPECT_EQ(tested(one), tested(three));
  EXPECT_GT(builds(shop) - needed, needed) << "revisions that may be next are asked beside the one that is";
  EXPECT_EQ(one["sessions"], three["sessions"]);
}

TEST(BisectScale, KeepsBuildsByCommit) {
  const Workshop shop;
  const HistoryPlan plan{.commits = 20, .fault = 14, .broken = {}};
  const History history(shop, plan);
  found(history, plan,
        history.bisect_by(with({"--good", history.commit(1), "--bad", "main", "--program", "bin/whole", "--cache",
                                "kept", "--jobs", "1"})));
  const std::ptrdiff_t first = builds(shop);
  EXPECT_GE(first, 6);
  const auto again = [&](const char* jobs) {
    return history.bisect_by(with(
        {"--good", history.commit(1), "--bad", "main", "--program", "bin/whole", "--cache", "kept", "--jobs", jobs}));
  };
  found(history, plan, again("1"));
  EXPECT_EQ(builds(shop), first) << "all were kept";
  const ordered_json json = found(history, plan, again("2"));
  EXPECT_EQ(json["before"]["commit"], history.commit(plan.fault - 1));
  const std::ptrdiff_t guesses = builds(shop) - first;
  EXPECT_LE(guesses, 6) << "only those are built that were not asked before";
  // A kept program that is damaged is built anew.
  for (const std::filesystem::directory_entry& one : std::filesystem::directory_iterator(shop.path("kept"))) {
    std::ofstream(one.path() / "program", std::ios::app) << "exit 3\n";
  }
  found(history, plan, again("2"));
  EXPECT_GE(builds(shop) - first - guesses, 6);
}

TEST(BisectScale, KeepsNoMoreThanItMay) {
  const Workshop shop;
  const HistoryPlan plan{.commits = 20, .fault = 14, .broken = {}};
  const History history(shop, plan);
  const auto kept = [&] {
    const std::filesystem::directory_iterator all(shop.path("kept"));
    return std::distance(begin(all), end(all));
  };
  const auto search = [&](const std::string& gb) {
    return tested(found(history, plan,
                        history.bisect_by(with({"--good", history.commit(1), "--bad", "main", "--program", "bin/whole",
                                                "--cache", "kept", "--cache-size", gb, "--jobs", "1"}))));
  };
  const std::vector<std::string> asked = search("0.0000025");  // 2.5 kB, and each program has about 1
  EXPECT_EQ(shop.names_with("-" + asked.front()), std::vector<std::string>()) << "the one used longest ago goes";
  EXPECT_FALSE(shop.names_with("-" + asked.back()).empty()) << "the last one stays";
  EXPECT_GE(kept(), 1);
  EXPECT_LE(kept(), 4);
  EXPECT_EQ(history.bisect_by(with({"--auto", "--cache", "kept", "--run", "engine {log}"})).exit, 2);
}

TEST(BisectScale, FindsAGoodRevisionBackFromTheBadOne) {
  const Workshop shop;
  const HistoryPlan plan{.commits = 40, .fault = 27, .broken = {32}};  // 8 back does not build
  const History history(shop, plan);
  const Outcome outcome = history.bisect_by(with({"--auto", "--program", "bin/tumble"}));
  const ordered_json json = found(history, plan, outcome);
  const std::vector<std::string> asked = tested(json);
  ASSERT_GE(asked.size(), 6U);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(asked[k], history.commit(40 - (std::size_t{1} << k) / 2)) << k;
  }
  EXPECT_EQ(json["before"]["commit"], history.commit(26));
  EXPECT_EQ(tested(found(history, plan, history.bisect_by(with({"--auto", "--program", "bin/tumble", "--jobs", "2"})))),
            asked);
}

TEST(BisectScale, SaysThatNoRevisionIsGood) {
  const Workshop shop;
  const History history(shop, {.commits = 6, .fault = 1, .broken = {}});
  const Outcome outcome = history.bisect_by(with({"--auto", "--program", "bin/tumble"}));
  EXPECT_EQ(outcome.exit, 2) << outcome.out;
  EXPECT_NE(outcome.err.find("found no revision with another answer"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("back to the first one, " + history.commit(1).substr(0, 10)), std::string::npos);
}

TEST(BisectScale, AsksAgainWhereAnAnswerIsNotRepeatable) {
  const Workshop shop;
  const HistoryPlan plan{.commits = 20, .fault = 14, .broken = {}};
  const History history(shop, plan);
  history.answer_otherwise_once();
  const ordered_json json = found(history, plan, history.bisect(with({"--jobs", "1"})));
  ASSERT_GE(json["tested"].size(), 3U);
  EXPECT_EQ(json["tested"][0]["not_repeatable"], "");
  EXPECT_EQ(json["tested"][2]["not_repeatable"], "4 of 5 times yes, 1 times no");
  history.answer_otherwise_once();
  const Outcome text = history.bisect({"session.tumble", "--metric", "lateral_max<=0", "--jobs", "1"});
  EXPECT_NE(text.out.find("is not repeatable (4 of 5 times yes"), std::string::npos) << text.out;
}

// An engine whose sessions depend on how often it ran. Its first runs may agree by chance: the fault is the engine's
// all the same, and not that of the log.
TEST(BisectScale, AnEndWhoseOwnSessionsDifferIsSaidToBeUnrepeatable) {
  for (const char* runs_alike : {"1", "3"}) {
    const Workshop shop;
    const History history(shop, {.commits = 6, .fault = 4, .broken = {}});
    shop.write("flaky.sh", "cd '" + shop.path("") + "' && echo run >>runs\nn=$(($(wc -l <runs) / " +
                               std::string(runs_alike) +
                               "))\nexec '" TUMBLE_PROGRAM
                               "' record \"$1\" -o \"$2\" --quiet --set \"box.1.velocity=[0.1$n,0.0,0.0]\"\n");
    const Outcome outcome = history.bisect(
        {"session.tumble", "--jobs", "1", "--run", "sh '" + shop.path("flaky.sh") + "' {scene} {log}", "--json"});
    EXPECT_EQ(outcome.exit, 2) << outcome.out;
    EXPECT_NE(outcome.err.find("is not repeatable: its own sessions differ from each other"), std::string::npos)
        << outcome.err;
  }
}

// A commit from which on two runs of one revision differ: its values are those of one run, and that is said.
TEST(BisectScale, NamesACommitThatMakesTheSessionUnrepeatable) {
  for (const char* asks : {"1", "2"}) {
    const Workshop shop;
    const HistoryPlan plan{.commits = 6, .fault = 4, .broken = {}};
    const History history(shop, plan);
    shop.write("flaky.sh", "n=00\n[ ! -s fault ] || { echo run >>'" + shop.path("runs") + "'; n=1$(wc -l <'" +
                               shop.path("runs") +
                               "'); }\nexec '" TUMBLE_PROGRAM
                               "' record \"$1\" -o \"$2\" --quiet --set \"box.1.velocity=[0.$n,0.0,0.0]\"\n");
    const std::vector<std::string> words = {
        "session.tumble", "--jobs", "1", "--asks", asks, "--run", "sh '" + shop.path("flaky.sh") + "' {scene} {log}"};
    const Outcome text = history.bisect(words);
    EXPECT_EQ(text.exit, 1) << text.out << text.err;
    const std::string name = history.commit(plan.fault).substr(0, 10);
    EXPECT_NE(
        text.out.find("from " + name + " on the session is not repeatable: two runs of it differ from each other"),
        std::string::npos)
        << text.out;
    std::vector<std::string> with_json = words;
    with_json.emplace_back("--json");
    const ordered_json json = found(history, plan, history.bisect(with_json));
    EXPECT_EQ(json["before"]["sessions_differ"], "");
    const std::string where = json["after"]["sessions_differ"];
    EXPECT_NE(where.find("body 1"), std::string::npos) << where;
  }
}

TEST(BisectScale, TakesTheMostFrequentAnswer) {
  const Answer yes{true, true, "yes", {}, {}}, no{true, false, "no", {}, {}}, none{false, false, "crashed", {}, {}};
  EXPECT_EQ(answer_of({yes, yes}).not_repeatable, "");
  EXPECT_TRUE(answer_of({no, yes, yes, no, yes}).yes);
  EXPECT_EQ(answer_of({no, yes, no, no, yes}).message, "no");
  EXPECT_FALSE(answer_of({none, yes, none, none, yes}).asked);
  const Answer tie = answer_of({no, yes});
  EXPECT_FALSE(tie.asked);
  EXPECT_EQ(tie.not_repeatable, "1 of 2 times yes, 1 times no");
  EXPECT_EQ(answer_of({none, none}).message, "crashed");
  Answer early = no, late = no;
  early.message = early.outcome = "step 3", late.message = late.outcome = "step 9";
  EXPECT_EQ(answer_of({early, late}).other, "step 9");
  EXPECT_EQ(answer_of({late, late}).other, "");
}

TEST(BisectScale, LeavesNothingWhereNothingWasAnswered) {
  const Workshop shop;
  const HistoryPlan plan{.commits = 3, .fault = 2, .broken = {}};
  const History history(shop, plan);
  const Outcome outcome = history.bisect_by({"session.tumble", "--good", "no-such-revision", "--bad", "HEAD"});
  EXPECT_EQ(outcome.exit, 2) << outcome.err;
  EXPECT_EQ(outcome.err.find("--resume"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(shop.path("work"))) << "the folder of work is still there";
}

}  // namespace
}  // namespace tumble::test
