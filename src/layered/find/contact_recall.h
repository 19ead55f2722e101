#pragma once

#include <span>
#include <utility>

#include "src/world/scratch.h"

namespace tumble::sim {

/// Hands out what the contacts of the last step have left, pair by pair. The memory is sorted as the pairs are visited,
/// so a cursor walks along: ask in ascending order of (lower row, higher row), kGround last. The memory must stay as it
/// is meanwhile.
class ContactRecall {
 public:
  /// For pairs whose lower row is `first` or higher.
  explicit ContactRecall(const ContactMemory& memory, BodyIndex first);

  /// Gives a new manifold the impulses that points of the same features had, and the friction.
  void warm_start(Manifold& manifold, std::span<ManifoldPoint> points);

  /// Of two resting bodies: appends what they remember as manifolds that are asleep. hi may be kGround.
  void keep(BodyIndex lo, BodyIndex hi, ManifoldList& to);

 private:
  std::pair<std::size_t, std::size_t> entries(BodyIndex lo, BodyIndex hi);

  const ContactMemory& memory_;
  std::size_t cursor_ = 0, point_ = 0;  // the next entry, and its first point
};

}  // namespace tumble::sim
