#include "src/layered/order/islands.h"

namespace tumble::sim {

Islands::Islands(std::vector<BodyIndex>& links, std::size_t bodies) : up_(links) {
  up_.resize(bodies);
  for (std::size_t i = 0; i < bodies; ++i) up_[i] = static_cast<BodyIndex>(i);
}

BodyIndex Islands::of(BodyIndex i) {
  while (up_[i] != i) {
    up_[i] = up_[up_[i]];
    i = up_[i];
  }
  return i;
}

void Islands::join(BodyIndex a, BodyIndex b) {
  const BodyIndex root_a = of(a), root_b = of(b);
  if (root_a != root_b) up_[root_a] = root_b;
}

bool touches(const Scratch& scratch, const Manifold& manifold) {
  if (manifold.asleep) return true;
  for (std::uint32_t k = manifold.first; k < manifold.first + manifold.count; ++k) {
    if (scratch.manifold_points[k].separation < kTouching) return true;
  }
  return false;
}

}  // namespace tumble::sim
