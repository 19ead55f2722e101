// Items in the order of their keys, counted by several workers: a stable sort, however many share it.
#include "src/sharing/key_counts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "src/base/rng.h"
#include "tumble/sim/workers.h"
#include "tumble/threads/worker_threads.h"

namespace tumble::sim {
namespace {

struct Sorted {
  std::vector<std::uint32_t> items;  // in the order of their keys
  std::vector<std::uint32_t> begin;  // of each key
  std::uint32_t all = 0;
};

Sorted sorted_by(WorkerThreads& workers, unsigned parts, const std::vector<std::uint32_t>& key, std::size_t keys,
                 std::vector<std::uint32_t>& memory) {
  Sorted sorted = {std::vector<std::uint32_t>(key.size()), std::vector<std::uint32_t>(keys), 0};
  work_together(&workers, parts, [&](const Worker& worker) {
    const Worker::Share own = worker.share(key.size());
    KeyCounts counts(memory, keys, worker);
    for (std::size_t k = own.begin; k < own.end; ++k) counts.add(key[k]);
    const std::uint32_t all =
        counts.find_places([&](std::size_t of, std::uint32_t begin) { sorted.begin[of] = begin; });
    for (std::size_t k = own.begin; k < own.end; ++k) {
      sorted.items[counts.take(key[k])] = static_cast<std::uint32_t>(k);
    }
    if (worker.first()) sorted.all = all;
  });
  return sorted;
}

void expect_sorted(WorkerThreads& workers, std::size_t keys, std::size_t items, std::vector<std::uint32_t>& memory) {
  std::vector<std::uint32_t> key(items), wanted(items);
  for (std::size_t k = 0; k < items; ++k) key[k] = static_cast<std::uint32_t>(random_bits(keys, k, items) % keys);
  std::iota(wanted.begin(), wanted.end(), 0U);
  std::ranges::stable_sort(wanted, {}, [&](std::uint32_t k) { return key[k]; });
  const Sorted sorted = sorted_by(workers, workers.count(), key, keys, memory);
  EXPECT_EQ(sorted.all, items);
  EXPECT_EQ(sorted.items, wanted) << workers.count() << " workers, " << keys << " keys, " << items << " items";
  for (std::uint32_t of = 0; of < keys; ++of) {
    EXPECT_EQ(sorted.begin[of], std::ranges::count_if(key, [&](std::uint32_t one) { return one < of; })) << of;
  }
}

TEST(KeyCounts, SortStablyWithAnyNumberOfWorkers) {
  std::vector<std::uint32_t> memory;  // used again, so that what is left in it must not show
  for (const unsigned parts : {1U, 2U, 3U, 7U}) {
    WorkerThreads workers(parts, Split::kEverything);
    for (const std::size_t keys : {1U, 5U, 16U, 100U}) {
      for (const std::size_t items : {0U, 1U, 6U, 1000U}) expect_sorted(workers, keys, items, memory);
    }
  }
}

}  // namespace
}  // namespace tumble::sim
