// The parts of a bisection, without git: every place of the fault, any commits that cannot be asked, the progress line.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <fstream>
#include <random>
#include <sstream>

#include "tools/bisect/build_progress.h"
#include "tools/bisect/plan.h"

namespace tumble::tools {
namespace {

using bisect::Candidate;
using bisect::Plan;

/// Commits 1 … n in a line, 1 known to be good. What git rev-list --bisect-all prints between two of them.
std::vector<Candidate> candidates_between(std::size_t good, std::size_t bad) {
  std::vector<Candidate> all;
  for (std::size_t n = good + 1; n <= bad; ++n) all.push_back({std::to_string(n), std::min(n - good, bad - n)});
  std::ranges::stable_sort(all, [](const Candidate& a, const Candidate& b) { return a.distance > b.distance; });
  return all;
}

struct Search {
  std::vector<std::string> suspects;
  std::size_t asked = 0;
};

Search search(std::size_t commits, std::size_t fault, const std::set<std::size_t>& broken) {
  Search search;
  std::size_t good = 1, bad = commits;
  std::set<std::string> skipped;
  while (true) {
    const Plan plan = bisect::next_step(candidates_between(good, bad), std::to_string(bad), skipped);
    EXPECT_EQ(plan.left, bad - good);
    search.suspects = plan.suspects;
    if (plan.test.empty()) return search;
    ++search.asked;
    EXPECT_FALSE(skipped.contains(plan.test)) << "asked twice";
    const std::size_t n = std::stoul(plan.test);
    if (broken.contains(n)) {
      skipped.insert(plan.test);
    } else {
      (n < fault ? good : bad) = n;
    }
  }
}

TEST(BisectPlan, FindsAFaultAnywhereInAsManyAnswersAsHalvingTakes) {
  for (const std::size_t commits : {2U, 3U, 7U, 64U, 100U}) {
    for (std::size_t fault = 2; fault <= commits; ++fault) {
      const Search found = search(commits, fault, {});
      EXPECT_EQ(found.suspects, std::vector<std::string>{std::to_string(fault)});
      EXPECT_LE(found.asked, std::bit_width(commits));
    }
  }
}

TEST(BisectPlan, GoesRoundWhatCannotBeAsked) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 300; ++trial) {
    const std::size_t fault = 2 + random() % 62;
    std::set<std::size_t> broken;
    const std::size_t first = 2 + random() % 55, count = 1 + random() % 8;
    for (std::size_t n = first; n < first + count; ++n) broken.insert(n);
    const Search found = search(64, fault, broken);
    EXPECT_EQ(std::ranges::count(found.suspects, std::to_string(fault)), 1) << "the fault is not among the suspects";
    std::size_t alike = 1;  // commits that nothing tells from the fault
    for (std::size_t n = fault; broken.contains(n) && n < 64; ++n) ++alike;
    for (std::size_t n = fault - 1; broken.contains(n); --n) ++alike;
    EXPECT_EQ(found.suspects.size(), alike) << "fault " << fault << ", broken from " << first << ", " << count;
    EXPECT_LE(found.asked, 7 + broken.size() + 2);
  }
}

TEST(BisectPlan, NothingToAskLeavesTheBadOne) {
  const Plan plan = bisect::next_step(candidates_between(4, 5), "5", {});
  EXPECT_TRUE(plan.test.empty());
  EXPECT_EQ(plan.suspects, std::vector<std::string>{"5"});
  EXPECT_EQ(plan.steps, 0U);
}

TEST(BuildProgress, FindsTheLastCounterOfNinjaOrMake) {
  EXPECT_EQ(bisect::last_counter("[1/260] Building a.o\n[2/260] Building b.o\nb.cc: warning: [x]\n"), "[2/260]");
  EXPECT_EQ(bisect::last_counter("[ 12%] Building a.o\n[ 13%] Bui"), "[ 13%]");
  EXPECT_EQ(bisect::last_counter("-- Configuring done\n[warning] [12] here\n"), "");
  EXPECT_EQ(bisect::last_counter(""), "");
}

TEST(BuildProgress, FindsWhatABuildFailedFor) {
  EXPECT_EQ(
      bisect::failure_in("[1/2] Building a.o\nFAILED: a.o\nc++ -o a.o\na.cc:7:3: error: no b3Pos\na.cc:9:3: error: "
                         "no b\nninja: build stopped: subcommand failed.\n"),
      "a.cc:7:3: error: no b3Pos");
  EXPECT_EQ(bisect::failure_in("ld: a.o: undefined reference to `b3Step'\ncollect2: error: ld returned 1\n"),
            "ld: a.o: undefined reference to `b3Step'");
  EXPECT_EQ(bisect::failure_in("-- gcc\nCMake Error at CMakeLists.txt:3 (add_subdirectory):\n\n  no folder x\n\n-- "
                               "Configuring incomplete, errors occurred!\n"),
            "CMake Error at CMakeLists.txt:3 (add_subdirectory): no folder x");
  EXPECT_EQ(bisect::failure_in("make: nothing\nsh: 1: cmake: not found\n \n"), "sh: 1: cmake: not found");
  EXPECT_EQ(bisect::failure_in("1 error generated\n"), "1 error generated");
  EXPECT_EQ(bisect::failure_in("\n"), "");
}

TEST(BuildProgress, TellsTheTimeInMinutesAndSeconds) {
  EXPECT_EQ(bisect::elapsed_text(std::chrono::seconds(45)), "45 s");
  EXPECT_EQ(bisect::elapsed_text(std::chrono::seconds(780)), "13 min 0 s");
}

TEST(BuildProgress, WritesLinesOrRewritesOne) {
  const std::string log = testing::TempDir() + "tumble_build_log.txt";
  std::ofstream(log) << "[3/9] Building a.o\n";
  std::ostringstream file, terminal, quick;
  bisect::BuildProgress(log, {file, false, std::chrono::seconds(0)}).show();
  EXPECT_EQ(file.str(), "      building [3/9], 0 s so far\n");
  bisect::BuildProgress(log, {terminal, true, std::chrono::seconds(0)}).show();
  EXPECT_EQ(terminal.str(), "\r      building [3/9], 0 s so far\033[K\r\033[K") << "gone afterwards";
  bisect::BuildProgress(log, {quick, false, std::chrono::minutes(1)}).show();
  EXPECT_EQ(quick.str(), "") << "a quick build needs no line";
}

}  // namespace
}  // namespace tumble::tools
