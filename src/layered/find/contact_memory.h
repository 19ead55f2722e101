#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// The pair of a contact of bodies a and b, either of which may be the lower row, or of the ground a and body b. A
/// memory is ascending by these pairs; several contacts of one pair follow one another.
inline ContactPair pair_of(BodyIndex a, BodyIndex b) {
  return a == kGround ? ContactPair(b, kGround) : ContactPair(std::min(a, b), std::max(a, b));
}
inline ContactPair pair_of(const ContactMemory& memory, std::size_t k) { return pair_of(memory.a[k], memory.b[k]); }

/// The number of contacts of pairs before `pair`.
std::size_t contacts_before(const ContactMemory& memory, const ContactPair& pair);

/// The number of points of the contacts before contact k.
std::size_t points_before(const ContactMemory& memory, std::size_t k);

/// The place of the first contact whose pair has the lower row `first` or a higher one.
inline MemoryPlace memory_place(const ContactMemory& memory, BodyIndex first) {
  const std::size_t contact = contacts_before(memory, {first, 0});
  return {contact, points_before(memory, contact)};
}

/// Writes the impulses of manifolds, ascending by pair, to the memory, for the warm start of the next step or substep.
/// Their points are those of the span, one manifold after the other. added: a memory of other pairs that is written
/// too, or null. homes: who of the workers has which manifolds.
void remember_contacts(std::span<const Manifold> manifolds, std::span<const ManifoldPoint> points,
                       const ContactMemory* added, const Homes& homes, Workers* workers, ContactMemory& memory);

}  // namespace tumble::sim
