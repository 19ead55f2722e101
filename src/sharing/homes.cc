#include "src/sharing/homes.h"

#include <algorithm>
#include <utility>

#include "src/base/check.h"

namespace tumble {
namespace {

// Items of a range in the mean that pay: four lines of doubles. Workers who split everything want homes at any price.
constexpr std::size_t kShortest = 32;

// Whether no worker has more than half as much again as its even share.
bool are_even(std::size_t most, std::size_t items, unsigned parts) { return most * parts <= items + items / 2; }

}  // namespace

void Homes::settle(std::span<const Range> ranges, std::size_t items, unsigned parts, const Workers& workers) {
  SIM_CHECK(parts > 1 && (ranges.empty() ? 0 : ranges.back().end) == items, parts, items);
  clear();
  items_ = items;
  next_.assign(parts + 1, 0);
  loads_.assign(parts, 0);
  std::uint32_t end = 0;
  for (const Range& range : ranges) {
    SIM_CHECK(range.worker < parts && range.begin == std::exchange(end, range.end), range.worker, range.begin);
    ++next_[range.worker + 1];
    loads_[range.worker] += range.end - range.begin;
  }
  const std::size_t most = *std::ranges::max_element(loads_);
  const std::size_t shortest = workers.worth(kShortest);
  if (ranges.size() * shortest > items || (shortest > 1 && !are_even(most, items, parts))) return;
  for (unsigned worker = 0; worker < parts; ++worker) next_[worker + 1] += next_[worker];
  first_ = next_;
  ranges_.reserve(items / shortest);  // so that a warm step allocates nothing
  ranges_.resize(ranges.size());
  std::uint32_t number = 0;
  for (const Range& range : ranges) {
    Range& own = ranges_[next_[range.worker]++];
    own = range;
    own.number = number++;
  }
}

void Homes::settle_told(unsigned parts, const Workers& workers) {
  const std::size_t items = worker_of_.size(), most = items / workers.worth(kShortest);
  told_parts_ = parts;
  all_.clear();
  all_.reserve(most + 1);
  clear();
  for (std::uint32_t begin = 0, end = 0; begin < items; begin = end) {
    if (all_.size() > most) return;  // too short to pay
    for (end = begin + 1; end < items && worker_of_[end] == worker_of_[begin]; ++end) continue;
    all_.push_back({begin, end, worker_of_[begin]});
  }
  settle(all_, items, parts, workers);
}

}  // namespace tumble
