#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tumble/sim/workers.h"

namespace tumble {

/// Which of several workers treats which items in all phases, so that the lines of an item stay with one processor. No
/// result may depend on it. Without homes, or where they are those of another number of items or workers, items are
/// cut evenly.
class Homes {
 public:
  /// Items that follow one another, and the worker who treats them.
  struct Range {
    std::uint32_t begin = 0, end = 0;
    std::uint32_t worker = 0;
    std::uint32_t number = 0;  ///< of this range among all, ascending; written by settle
  };

  void clear() { first_.clear(); }

  /// Takes ranges that make up [0, items), ascending, of workers < parts, at least 2 and at most 256. Keeps none where
  /// they are too short, or the shares of workers too uneven, to pay.
  void settle(std::span<const Range> ranges, std::size_t items, unsigned parts, const Workers& workers);
  /// Likewise from the worker of each item: begin(), then tell() for every item, by several workers at a time, then
  /// settle_told().
  void begin(std::size_t items) { worker_of_.resize(items); }
  void tell(std::size_t item, unsigned worker) { worker_of_[item] = static_cast<std::uint8_t>(worker); }
  void settle_told(unsigned parts, const Workers& workers);
  /// Whether the workers of so many items were told last among so many, whether or not they pay.
  [[nodiscard]] bool were_told(std::size_t items, unsigned parts) const {
    return told_parts_ == parts && worker_of_.size() == items;
  }

  /// Whether there are homes for so many items and workers.
  [[nodiscard]] bool fit(std::size_t items, unsigned parts) const {
    return !first_.empty() && first_.size() == parts + 1 && items_ == items;
  }
  /// Of ranges, where there are homes.
  [[nodiscard]] std::size_t size() const { return ranges_.size(); }
  /// The ranges of a worker, ascending. Precondition: there are homes.
  [[nodiscard]] std::span<const Range> of(unsigned worker) const {
    return std::span(ranges_).subspan(first_[worker], first_[worker + 1] - first_[worker]);
  }
  /// The worker of an item. Precondition: it was told.
  [[nodiscard]] unsigned worker_of(std::size_t item) const { return worker_of_[item]; }

  /// The number of workers who treat so many items: 1 if each of several would have fewer than `least`; all who have
  /// homes, unless each would have less than half of it.
  [[nodiscard]] unsigned parts_for(const Workers* workers, std::size_t items, std::size_t least) const {
    const unsigned parts = part_count(workers, items, least);
    if (parts == 1 || first_.empty()) return parts;
    const auto settled = static_cast<unsigned>(first_.size() - 1);
    return settled <= workers->count() && settled <= 2 * parts && fit(items, settled) ? settled : parts;
  }

  /// Calls visit(begin, end, slot) for the items of one of the workers of a round. Slots ascend with the items, and are
  /// less than slots().
  template <class Visit>
  void for_own_slots(const Worker& worker, std::size_t items, Visit visit) const {
    if (!fit(items, worker.parts)) {
      const Worker::Share share = worker.share(items);
      return visit(share.begin, share.end, std::size_t{worker.part});
    }
    for (const Range& range : of(worker.part)) {
      visit(std::size_t{range.begin}, std::size_t{range.end}, std::size_t{range.number});
    }
  }
  [[nodiscard]] std::size_t slots(std::size_t items, unsigned parts) const {
    return fit(items, parts) ? size() : parts;
  }
  /// Likewise visit(begin, end).
  template <class Visit>
  void for_own(const Worker& worker, std::size_t items, Visit visit) const {
    for_own_slots(worker, items, [&](std::size_t begin, std::size_t end, std::size_t /*slot*/) { visit(begin, end); });
  }

  /// As for_ranges: calls visit(begin, end) for ranges that make up [0, items), by several workers at a time.
  template <class Visit>
  void for_all(Workers* workers, std::size_t items, std::size_t least, Visit visit) const {
    const unsigned parts = parts_for(workers, items, least);
    if (parts == 1) return visit(std::size_t{0}, items);
    work_together(workers, parts, [&](const Worker& worker) { for_own(worker, items, visit); });
  }

  /// Bytes.
  [[nodiscard]] std::size_t held() const {
    return (all_.capacity() + ranges_.capacity()) * sizeof(Range) + worker_of_.capacity() +
           (first_.capacity() + next_.capacity()) * sizeof(std::uint32_t) + loads_.capacity() * sizeof(std::size_t);
  }

 private:
  std::vector<std::uint8_t> worker_of_;  // by item
  std::vector<Range> all_, ranges_;      // ascending, for a moment; worker by worker
  std::vector<std::uint32_t> first_;     // by worker, in ranges_; one more at the end
  std::vector<std::uint32_t> next_;      // by worker, while they are settled
  std::vector<std::size_t> loads_;       // likewise
  std::size_t items_ = 0;
  unsigned told_parts_ = 0;
};

}  // namespace tumble
