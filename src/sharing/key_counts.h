#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "tumble/sim/workers.h"

namespace tumble {

/// Items put in the order of their keys in linear time, by several workers who have a range of the items each. Every
/// worker counts the keys of its own items, so that no counter travels between processors; then it knows where its
/// items of a key begin. Items of one key stay in order.
///
/// In the task of a round each worker makes one, calls add() for its items, then find_places(), then take() for its
/// items in the same order.
class KeyCounts {
 public:
  /// memory: that of all workers, which nothing else may use until they have met after the last take().
  KeyCounts(std::vector<std::uint32_t>& memory, std::size_t keys, const Worker& worker)
      : keys_(keys), row_((keys / kLine + 2) * kLine), worker_(worker) {
    if (worker.first() && memory.size() < row_ * worker.parts) memory.resize(row_ * worker.parts);
    worker.meet();
    all_ = memory.data();
    own_ = all_ + worker.part * row_;
    std::fill_n(own_, keys, 0U);
  }

  void add(std::uint32_t key) { ++own_[key]; }

  /// Returns the number of all items. visit(key, begin): by one of the workers for each key, where its items begin.
  template <class Visit>
  std::uint32_t find_places(Visit visit) {
    if (worker_.parts == 1) return find_alone(visit);
    worker_.meet();
    const Worker::Share share = worker_.share(keys_);
    std::uint32_t own = 0;
    for (unsigned part = 0; part < worker_.parts; ++part) {
      const std::uint32_t* const counts = all_ + part * row_;
      for (std::size_t key = share.begin; key < share.end; ++key) own += counts[key];
    }
    own_[row_ - 1] = own;  // behind the keys
    worker_.meet();
    std::uint32_t before = 0, sum = 0;
    for (unsigned part = 0; part < worker_.parts; ++part) {
      if (part == worker_.part) before = sum;
      sum += all_[part * row_ + row_ - 1];
    }
    place(share, before, visit);
    worker_.meet();
    return sum;
  }
  std::uint32_t find_places() {
    return find_places([](std::size_t /*key*/, std::uint32_t /*begin*/) {});
  }

  /// The place of this worker's next item of the key.
  std::uint32_t take(std::uint32_t key) { return own_[key]++; }

 private:
  static constexpr std::size_t kLine = 16;  // numbers in a cache line

  template <class Visit>
  std::uint32_t find_alone(Visit visit) {
    std::uint32_t at = 0;
    for (std::size_t key = 0; key < keys_; ++key) {
      visit(key, at);
      at += std::exchange(own_[key], at);
    }
    return at;
  }
  // Makes the counts of keys in a range into places, from `at` on.
  template <class Visit>
  void place(const Worker::Share& share, std::uint32_t at, Visit visit) {
    for (std::size_t key = share.begin; key < share.end; ++key) {
      visit(key, at);
      for (std::size_t k = key, part = 0; part < worker_.parts; ++part, k += row_) at += std::exchange(all_[k], at);
    }
  }

  std::size_t keys_, row_;
  Worker worker_;
  std::uint32_t* all_ = nullptr;  // by worker and key
  std::uint32_t* own_ = nullptr;
};

}  // namespace tumble
