#include "src/scenes/body_ids.h"

#include <algorithm>

namespace tumble::scenes {

void BodyIds::reserve(sim::BodyId first, std::uint64_t count, const Place& place, const std::string& what,
                      Problem& problem) {
  if (count - 1 > sim::kBodyIdMax - first) {
    problem.report(place, what + ": " +
                              found_wanted(std::to_string(first) + " for " + std::to_string(count) + " bodies",
                                           "ids up to " + std::to_string(sim::kBodyIdMax)));
    return;
  }
  reserved_.push_back({first, first + (count - 1), reserved_.size(), place, what});
}

void BodyIds::finish_reserving(Problem& problem) {
  std::sort(reserved_.begin(), reserved_.end(),
            [](const Range& a, const Range& b) { return a.first != b.first ? a.first < b.first : a.asked < b.asked; });
  for (std::size_t i = 1; i < reserved_.size(); ++i) {
    const Range& a = reserved_[i - 1];
    const Range& b = reserved_[i];
    if (b.first > a.last) continue;
    const Range& early = a.asked < b.asked ? a : b;
    const Range& late = a.asked < b.asked ? b : a;
    problem.report(late.place, late.what + ": " +
                                   found_wanted("id " + std::to_string(b.first),
                                                "ids that no other body has (taken by " + early.what + " at " +
                                                    problem.place_text(early.place) + ")"));
    return;
  }
}

sim::BodyId BodyIds::next() {
  for (; skipped_ < reserved_.size() && reserved_[skipped_].first <= next_; ++skipped_) {
    next_ = reserved_[skipped_].last + 1;
  }
  return next_++;
}

}  // namespace tumble::scenes
