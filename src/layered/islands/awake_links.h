#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Whether nothing in a step moves the body: the ground, a static or a sleeping one.
inline bool at_rest(const Bodies& bodies, BodyIndex i) { return i == kGround || !bodies.moves(i); }

/// A body of the contact that moves, in whose island it lies.
inline BodyIndex mover_of(const Bodies& bodies, const ContactGraph::Link& link) {
  return at_rest(bodies, link.b) ? link.a : link.b;
}

/// Calls visit(link) for all awake contacts, by several workers at a time.
template <class Visit>
void for_awake(const Scratch& scratch, Visit visit) {
  const std::vector<ContactGraph::Link>& links = scratch.graph.links;
  for_ranges(scratch.workers, links.size(), kManifoldsAPart, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (links[k].awake) visit(links[k]);
    }
  });
}

}  // namespace tumble::sim
