#include "src/world/islands.h"

#include <utility>

namespace tumble::sim {
Islands::Islands(std::vector<BodyIndex>& links, std::size_t bodies, Workers* workers) : up_(links) {
  up_.resize(bodies);
  for_ranges(workers, bodies, kBodiesAPart, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) up_[i] = static_cast<BodyIndex>(i);
  });
}

// Another worker may write a link at the same time; whichever is written last leads up the same tree.
BodyIndex Islands::of(BodyIndex i) {
  for (;;) {
    const BodyIndex up = shared::read(up_[i]);
    if (up == i) return i;
    const BodyIndex above = shared::read(up_[up]);
    if (above == up) return up;
    shared::write(up_[i], above);
    i = above;
  }
}

void Islands::join(BodyIndex a, BodyIndex b) {
  for (;;) {
    BodyIndex high = of(a);
    BodyIndex low = of(b);
    if (high == low) return;
    if (high < low) std::swap(high, low);
    if (shared::exchange(up_[high], high, low)) return;
  }
}

bool touches(const Scratch& scratch, const Manifold& manifold) {
  if (manifold.asleep) return true;
  for (std::uint32_t k = manifold.first; k < manifold.first + manifold.count; ++k) {
    if (scratch.manifold_points[k].separation < kTouching) return true;
  }
  return false;
}

}  // namespace tumble::sim
