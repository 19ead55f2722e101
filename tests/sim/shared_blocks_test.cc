// Blocks that workers take: each is done once, and a worker that is held up loses its blocks to the others.
#include "src/sharing/shared_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <vector>

#include "tumble/sim/workers.h"
#include "tumble/threads/worker_threads.h"

namespace tumble::sim {
namespace {

TEST(SharedBlocks, AreTakenOnceEach) {
  std::vector<SharedBlocks::Range> memory;  // used again, so that what is left in it must not show
  for (const unsigned parts : {1U, 2U, 3U, 7U}) {
    WorkerThreads workers(parts, Split::kEverything);
    for (const std::size_t blocks : {0U, 1U, 6U, 1000U}) {
      std::vector<std::atomic<int>> taken(blocks);
      work_together(&workers, parts, [&](const Worker& worker) {
        SharedBlocks(memory, worker.share(blocks), worker).take_all([&](std::size_t k) { ++taken[k]; });
      });
      EXPECT_TRUE(std::ranges::all_of(taken, [](int times) { return times == 1; })) << parts << " workers";
    }
  }
}

// The first worker stays in its first block until all others are done.
TEST(SharedBlocks, OfAWorkerThatIsHeldUpGoToTheOthers) {
  constexpr std::size_t kBlocks = 8;
  WorkerThreads workers(2, Split::kEverything);
  std::vector<SharedBlocks::Range> memory;
  std::vector<unsigned> taken_by(kBlocks);
  std::atomic<std::size_t> done = 0;
  work_together(&workers, 2, [&](const Worker& worker) {
    SharedBlocks(memory, worker.share(kBlocks), worker).take_all([&](std::size_t k) {
      taken_by[k] = worker.part;
      while (k == 0 && done < kBlocks - 1) continue;
      ++done;
    });
  });
  EXPECT_EQ(taken_by, (std::vector<unsigned>{0, 1, 1, 1, 1, 1, 1, 1}));
}

}  // namespace
}  // namespace tumble::sim
