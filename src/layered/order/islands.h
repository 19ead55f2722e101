#pragma once

#include <vector>

#include "src/world/scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// Bodies that hang together through contacts: a partition into sets. Which member stands for a set depends on the
/// order of joining; which bodies share a set does not, and nothing else may be asked.
class Islands {
 public:
  /// Every body by itself. `links` is the memory for it: a set lasts until the next is made of the same.
  Islands(std::vector<BodyIndex>& links, std::size_t bodies);
  void join(BodyIndex a, BodyIndex b);
  /// Equal for two bodies exactly when they are in one set.
  [[nodiscard]] BodyIndex of(BodyIndex i);

 private:
  std::vector<BodyIndex>& up_;
};

/// Manifolds closer than this, m, are contacts that carry.
inline constexpr double kTouching = 0.02;

/// Whether a manifold has a point that close, or joins two resting bodies.
bool touches(const Scratch& scratch, const Manifold& manifold);

}  // namespace tumble::sim
