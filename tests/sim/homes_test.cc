// Homes of items: whoever has which, all are treated once; without homes that fit they are cut evenly.
#include "src/sharing/homes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

#include "tests/support/sim_scenes.h"
#include "tumble/sim/step.h"
#include "tumble/sim/workers.h"
#include "tumble/threads/worker_threads.h"

namespace tumble::sim {
namespace {

void settle(Homes& homes, const std::vector<std::uint8_t>& of, unsigned parts, const Workers& workers) {
  homes.begin(of.size());
  for (std::size_t k = 0; k < of.size(); ++k) homes.tell(k, of[k]);
  homes.settle_told(parts, workers);
  EXPECT_TRUE(homes.were_told(of.size(), parts));
}

// By item, how often it was treated and by which worker last.
struct Treated {
  explicit Treated(std::size_t items) : times(items), worker(items) {}
  std::vector<std::atomic<int>> times;
  std::vector<std::uint8_t> worker;
};

Treated treat(const Homes& homes, Workers& workers, std::size_t items, unsigned parts) {
  Treated treated(items);
  work_together(&workers, parts, [&](const Worker& worker) {
    homes.for_own(worker, items, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        ++treated.times[k];
        treated.worker[k] = static_cast<std::uint8_t>(worker.part);
      }
    });
  });
  EXPECT_TRUE(std::ranges::all_of(treated.times, [](int times) { return times == 1; }));
  return treated;
}

TEST(Homes, EachWorkerTreatsItsOwn) {
  WorkerThreads workers(3, Split::kEverything);
  const std::vector<std::uint8_t> wanted = {2, 2, 0, 1, 1, 1, 0, 0, 2};
  Homes homes;
  settle(homes, wanted, 3, workers);
  ASSERT_TRUE(homes.fit(wanted.size(), 3));
  EXPECT_EQ(treat(homes, workers, wanted.size(), 3).worker, wanted);
  EXPECT_EQ(homes.parts_for(&workers, wanted.size(), 1), 3U);
  EXPECT_EQ(homes.slots(wanted.size(), 3), 5U);
  std::vector<std::size_t> slots(wanted.size());
  for (unsigned part = 0; part < 3; ++part) {
    homes.for_own_slots(Worker{&workers, part, 3}, wanted.size(),
                        [&](std::size_t begin, std::size_t end, std::size_t slot) {
                          std::fill(slots.begin() + static_cast<std::ptrdiff_t>(begin),
                                    slots.begin() + static_cast<std::ptrdiff_t>(end), slot);
                        });
  }
  EXPECT_EQ(slots, (std::vector<std::size_t>{0, 0, 1, 2, 2, 2, 3, 3, 4}));
}

TEST(Homes, OfOtherItemsOrWorkersAreLeftAside) {
  WorkerThreads workers(3, Split::kEverything);
  Homes homes;
  const std::vector<std::uint8_t> even = {0, 0, 0, 1, 1, 1, 2, 2, 2};
  EXPECT_EQ(treat(homes, workers, 9, 3).worker, even) << "no homes";
  settle(homes, {2, 2, 0, 1, 1, 1, 0, 0}, 3, workers);
  EXPECT_EQ(treat(homes, workers, 9, 3).worker, even) << "of fewer items";
  settle(homes, {1, 1, 1, 0, 0, 0, 1, 0, 1}, 2, workers);
  EXPECT_EQ(treat(homes, workers, 9, 3).worker, even) << "of fewer workers";
  WorkerThreads one(1, Split::kEverything);
  EXPECT_EQ(homes.parts_for(&one, 9, 1), 1U) << "workers who are gone";
  homes.clear();
  EXPECT_FALSE(homes.fit(9, 2));
}

TEST(Homes, AreKeptWhereTheyPay) {
  WorkerThreads workers(2);
  const auto fits = [&](std::size_t run, std::size_t first) {  // runs of one length, of which the first worker has some
    std::vector<std::uint8_t> of(1000 * run);
    for (std::size_t k = 0; k < of.size(); ++k) of[k] = k / run % 10 < first ? 0 : 1;
    for (std::size_t k = 0; first == 5 && k < of.size(); ++k) of[k] = static_cast<std::uint8_t>(k / run % 2);
    Homes homes;
    settle(homes, of, 2, workers);
    return homes.fit(of.size(), 2);
  };
  EXPECT_TRUE(fits(32, 5));
  EXPECT_FALSE(fits(31, 5)) << "short ranges";
  EXPECT_TRUE(fits(32, 7));
  EXPECT_FALSE(fits(32, 8)) << "one worker with four fifths";
}

}  // namespace
}  // namespace tumble::sim
