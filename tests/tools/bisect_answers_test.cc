// `tumble bisect` answers the question that was asked, about the session that was given, or says why it cannot.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/history.h"

namespace tumble::test {
namespace {

// Whose build made no program, so that there is nothing to keep: its own fault, and no end of the search.
TEST(BisectAnswers, ABuildWithoutItsProgramIsSkipped) {
  const Workshop shop;
  const History history(shop, {.commits = 4, .fault = 3, .broken = {}});
  const Outcome outcome = history.bisect_by({"--good", history.commit(1), "--bad", "main", "--program", "bin/none",
                                             "--cache", "kept", "session.tumble", "--metric", "lateral_max<=0"});
  EXPECT_EQ(outcome.exit, 4);
  EXPECT_NE(outcome.err.find("the good revision"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("cannot be asked"), std::string::npos) << outcome.err;
}

TEST(BisectAnswers, NoArgumentIsIgnored) {
  const Workshop shop;
  const History history(shop, {.commits = 4, .fault = 3, .broken = {}});
  const auto refuses = [&](std::vector<std::string> words, const std::string& found) {
    words.insert(words.begin(), "bisect");
    const Outcome outcome = shop.run(words);
    EXPECT_EQ(outcome.exit, 2) << outcome.out;
    EXPECT_NE(outcome.err.find(found), std::string::npos) << outcome.err;
  };
  for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{{"--metric", "drift_max<=0"},
                                                                                    {"--bodies", "1"},
                                                                                    {"--case", "fall"},
                                                                                    {"--image"},
                                                                                    {"--repo", "project"},
                                                                                    {"--first-parent"},
                                                                                    {"--build", "true"},
                                                                                    {"--run", "x {log}"},
                                                                                    {"--jobs", "2"},
                                                                                    {"--asks", "3"},
                                                                                    {"--cache", "kept"},
                                                                                    {"--resume"},
                                                                                    {"--keep"},
                                                                                    {"--timeout", "3"},
                                                                                    {"--work", "work"}}) {
    std::vector<std::string> words = {"session.tumble", "session.tumble"};
    words.insert(words.end(), more.begin(), more.end());
    refuses(words, more.front() + ": found with two logs");
  }
  const std::vector<std::string> one = {"--repo", "project", "--auto", "session.tumble"};
  const auto with_one = [&](std::vector<std::string> more) {
    more.insert(more.begin(), one.begin(), one.end());
    return more;
  };
  refuses(with_one({"--shared"}), "--shared: found with one log");
  refuses(with_one({"--from-step", "3"}), "--from-step: found without --metric");
}

// A list of answers is about one log, and is not always what this program wrote.
TEST(BisectAnswers, ResumesOnlyWhatItWroteAboutThisLog) {
  const Workshop shop;
  const History history(shop, {.commits = 4, .fault = 3, .broken = {}});
  const std::vector<std::string> question = {"session.tumble", "--keep"},
                                 again = {"session.tumble", "--keep", "--resume"};
  ASSERT_EQ(history.bisect(question).exit, 1);
  const std::string state = shop.read("work/state.json"), session = shop.read("session.tumble");
  for (const char* damage : {"[]", "{\"question\": 3}", "{\"question\": \"\", \"answers\": [7]}",
                             "{\"answers\": [{\"commit\": \"a\", \"asked\": \"yes\", \"yes\": true}]}", "{"}) {
    shop.write("work/state.json", damage);
    const Outcome damaged = history.bisect(again);
    EXPECT_EQ(damaged.exit, 3) << damage << damaged.err;
    EXPECT_NE(damaged.err.find("state.json"), std::string::npos) << damaged.err;
  }
  shop.write("work/state.json", state);
  EXPECT_EQ(history.bisect(again).exit, 1);
  shop.write("work/state.json", state);
  ASSERT_EQ(shop.run({"record", "scene.toml", "--quiet", "--steps", "7", "-o", "session.tumble"}).exit, 0);
  ASSERT_NE(shop.read("session.tumble"), session);
  const Outcome other = history.bisect(again);
  EXPECT_EQ(other.exit, 2) << "answers about the log that was there before\n" << other.out;
  EXPECT_NE(other.err.find("another bisection"), std::string::npos) << other.err;
}

// A clone that another user owns is the usual one in a container of a CI service: git says what to do.
TEST(BisectAnswers, WhatGitAdvisesIsPassedOn) {
  const Workshop shop;
  const History history(shop, {.commits = 2, .fault = 3, .broken = {}});
  const Outcome refused =
      shop.run_after("GIT_TEST_ASSUME_DIFFERENT_OWNER=1; export GIT_TEST_ASSUME_DIFFERENT_OWNER; ",
                     {"bisect", "--repo", "project", "--good", "HEAD~1", "--bad", "HEAD", "session.tumble"});
  EXPECT_EQ(refused.exit, 2) << refused.out;
  EXPECT_NE(refused.err.find("git advises: git config --global --add safe.directory"), std::string::npos)
      << refused.err;
}

// Inputs that were made while the session ran are in no scene: the lengths of steps in real time, say.
TEST(BisectAnswers, AMetricIsOfTheSessionWithAllItsInputs) {
  const Workshop shop;
  const History history(shop, {.commits = 2, .fault = 3, .broken = {}});  // none shows it
  ASSERT_EQ(shop.run({"record", "scene.toml", "--quiet", "--realtime", "--steps", "7", "-o", "played.tumble"}).exit, 0);
  const Outcome outcome = history.bisect({"played.tumble", "--metric", "lateral_max<=1", "--keep"});
  ASSERT_EQ(outcome.exit, 2) << outcome.err;
  const std::string anew = "work/sessions/" + history.commit(1) + ".tumble";
  const Outcome same = shop.run({"diff", "played.tumble", anew});
  EXPECT_EQ(same.exit, 0) << same.out << same.err;
}

}  // namespace
}  // namespace tumble::test
