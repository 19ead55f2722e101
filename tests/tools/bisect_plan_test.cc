// The parts of a bisection, without git: every place of the fault, any commits that cannot be asked, the progress line.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>

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

}  // namespace
}  // namespace tumble::tools
