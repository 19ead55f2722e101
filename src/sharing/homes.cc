#include "src/sharing/homes.h"

#include <algorithm>

#include "src/base/check.h"

namespace tumble {
namespace {

constexpr std::size_t kShortest = 32;  // items of a range in the mean that pay: four lines of doubles

}  // namespace

void Homes::settle(std::span<const Range> ranges, std::size_t items, unsigned parts, const Workers& workers) {
  SIM_CHECK(ranges.empty() || ranges.back().end == items, items);
  clear();
  items_ = items;
  next_.assign(parts + 1, 0);
  loads_.assign(parts, 0);
  for (const Range& range : ranges) {
    ++next_[range.worker + 1];
    loads_[range.worker] += range.end - range.begin;
  }
  const std::size_t most = *std::ranges::max_element(loads_);
  const bool pays = ranges.size() * kShortest <= items && most * parts <= items + items / 2;
  if (parts == 1 || (!pays && workers.worth(kShortest) == kShortest)) return;
  for (unsigned worker = 0; worker < parts; ++worker) next_[worker + 1] += next_[worker];
  first_ = next_;
  ranges_.resize(ranges.size());
  std::uint32_t number = 0;
  for (const Range& range : ranges) {
    Range& own = ranges_[next_[range.worker]++];
    own = range;
    own.number = number++;
  }
}

void Homes::settle(std::span<const std::uint8_t> worker_of, unsigned parts, const Workers& workers) {
  worker_of_.assign(worker_of.begin(), worker_of.end());
  all_.clear();
  for (std::uint32_t begin = 0, end = 0; begin < worker_of.size(); begin = end) {
    for (end = begin + 1; end < worker_of.size() && worker_of[end] == worker_of[begin]; ++end) continue;
    all_.push_back({begin, end, worker_of[begin]});
  }
  settle(all_, worker_of.size(), parts, workers);
}

}  // namespace tumble
