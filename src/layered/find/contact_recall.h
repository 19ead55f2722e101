#pragma once

#include <span>
#include <utility>

#include "src/world/scratch.h"

namespace tumble::sim {

/// Reads the contact memory pair by pair. Memory and pairs have the same order, and each call continues where the call
/// before ended: call in ascending order of (lower row, higher row), kGround last. The memory must outlive the object
/// and must not change.
class ContactRecall {
 public:
  /// Starts at the pairs whose lower row is that of this place or higher (memory_place).
  ContactRecall(const ContactMemory& memory, const MemoryPlace& from)
      : memory_(memory), cursor_(from.contact), point_(from.point) {}

  /// Whether a point of the pair pressed. hi may be kGround.
  bool pressed(BodyIndex lo, BodyIndex hi);

  /// Gives a new manifold the remembered impulses of points with equal features, and the remembered friction.
  void warm_start(Manifold& manifold, std::span<ManifoldPoint> points);

  /// Appends the remembered contacts of two resting bodies as manifolds that are asleep. hi may be kGround.
  void keep(BodyIndex lo, BodyIndex hi, ManifoldList& to);

 private:
  std::pair<std::size_t, std::size_t> entries(BodyIndex lo, BodyIndex hi);

  const ContactMemory& memory_;
  std::size_t cursor_, point_;  // the next entry, and its first point
};

}  // namespace tumble::sim
