#pragma once

#include <cstddef>
#include <span>

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"

namespace tumble::sim {

/// Manifolds of a block: they are added, then their points.
inline constexpr std::size_t kManifoldsABlock = 32;

/// Adds the manifolds [begin, end) of a list and their points, which lie in the order of the manifolds; begin is the
/// start of a block, end as well or the end of the list.
void add_manifolds(std::span<const Manifold> manifolds, std::span<const ManifoldPoint> points, std::size_t begin,
                   std::size_t end, Hasher& hasher);

/// Feeds a hasher with a list that grows; without one, does nothing.
class ManifoldFeed {
 public:
  explicit ManifoldFeed(Hasher* hasher) : hasher_(hasher) {}

  void add_whole_blocks(const ManifoldList& list) {
    const std::size_t count = list.manifolds.size();
    if (hasher_ != nullptr && count >= fed_ + kManifoldsABlock) add(list, count / kManifoldsABlock * kManifoldsABlock);
  }
  void add_rest(const ManifoldList& list) {
    if (hasher_ != nullptr) add(list, list.manifolds.size());
  }

 private:
  void add(const ManifoldList& list, std::size_t end) {
    add_manifolds(list.manifolds, list.points, fed_, end, *hasher_);
    fed_ = end;
  }

  Hasher* hasher_;
  std::size_t fed_ = 0;  // manifolds
};

/// Adds the manifolds of the step and their points.
void hash_manifolds(const Scratch& scratch, Hasher& hasher);

/// Adds the fields of a row in the order in which they lie in memory.
void add_fields(const Manifold& m, Hasher& hasher);
void add_fields(const ManifoldPoint& point, Hasher& hasher);

}  // namespace tumble::sim
