#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tumble/sim/workers.h"

namespace tumble {

/// Blocks of work that several workers take one by one, where nobody knows beforehand how long each takes. A worker has
/// a range of the blocks and takes them in order; when it is done, it takes those at the ends of the others' ranges. So
/// a worker mostly does the same blocks in every step, whose lines its processor holds (Blumofe and Leiserson 1999,
/// Scheduling multithreaded computations by work stealing). Which worker does a block depends on time, so no result
/// may.
class SharedBlocks {
 public:
  /// The blocks of one worker that nobody has taken: the first, and behind the last in the upper half.
  struct alignas(64) Range {
    std::uint64_t left = 0;
  };

  /// In the task of a round each worker makes one. memory: that of all workers. own: the blocks of this one.
  SharedBlocks(std::vector<Range>& memory, const Worker::Share& own, const Worker& worker) : worker_(worker) {
    if (worker.first() && memory.size() < worker.parts) memory.resize(worker.parts);
    worker.meet();
    all_ = memory.data();
    all_[worker.part].left = range(own.begin, own.end);
    worker.meet();
  }

  /// Calls visit(block) for each block that this worker takes, until none is left.
  template <class Visit>
  void take_all(Visit visit) {
    for (std::size_t block = 0; take(all_[worker_.part], true, block);) visit(block);
    if (worker_.parts > 1 && worker_.all->take_turns()) return;
    for (unsigned k = 1; k < worker_.parts; ++k) {
      Range& other = all_[(worker_.part + k) % worker_.parts];
      for (std::size_t block = 0; take(other, false, block);) visit(block);
    }
  }

 private:
  static constexpr unsigned kHalf = 32;  // bits
  static std::uint64_t range(std::uint64_t begin, std::uint64_t end) { return end << kHalf | begin; }

  // Takes the first or the last block of a range; false: none is left.
  static bool take(Range& from, bool first, std::size_t& block) {
    for (;;) {
      const std::uint64_t left = shared::read(from.left);
      const std::uint64_t begin = left & 0xffffffffU, end = left >> kHalf;
      if (begin == end) return false;
      block = first ? begin : end - 1;
      if (shared::exchange(from.left, left, first ? range(begin + 1, end) : range(begin, end - 1))) return true;
    }
  }

  Worker worker_;
  Range* all_ = nullptr;
};

/// As for_ranges, in blocks of some items that workers take over from each other. memory: of SharedBlocks.
template <class Visit>
void for_shared_blocks(Workers* workers, std::vector<SharedBlocks::Range>& memory, std::size_t items, std::size_t least,
                       std::size_t block, Visit visit) {
  const std::size_t blocks = (items + block - 1) / block;
  work_together(workers, part_count(workers, items, least), [&](const Worker& worker) {
    SharedBlocks(memory, worker.share(blocks), worker).take_all([&](std::size_t k) {
      visit(k * block, std::min(items, (k + 1) * block));
    });
  });
}

}  // namespace tumble
