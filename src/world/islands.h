#pragma once

#include <vector>

#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Islands: the partition of bodies into sets that contacts connect (union-find with path halving, Tarjan and van
/// Leeuwen 1984). The lowest row of a set stands for it. Several workers may join at a time, and may ask when all have
/// joined: a root is hung below a lower one by one atomic exchange (Anderson and Woll 1991).
class Islands {
 public:
  /// Starts with one set for every body. `links` is the memory of the sets. It must outlive the object; two objects
  /// must not use the same links at a time.
  Islands(std::vector<BodyIndex>& links, std::size_t bodies, Workers* workers);
  /// Joins the sets of two bodies.
  void join(BodyIndex a, BodyIndex b);
  /// The body that stands for the set of i: equal for two bodies exactly if they share a set.
  [[nodiscard]] BodyIndex of(BodyIndex i);

 private:
  std::vector<BodyIndex>& up_;
};

/// Separation below which a point counts as touching, m.
inline constexpr double kTouching = 0.02;

/// Whether a manifold has a point that touches, or is asleep.
bool touches(const Scratch& scratch, const Manifold& manifold);

}  // namespace tumble::sim
