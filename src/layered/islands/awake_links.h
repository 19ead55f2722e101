#pragma once

#include "src/model/mass.h"
#include "src/world/for_bodies.h"
#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Whether a step moves the body: not the ground, nor a static or a sleeping one.
inline bool moves(const Bodies& bodies, BodyIndex i) { return i != kGround && bodies.moves(i); }
inline bool at_rest(const Bodies& bodies, BodyIndex i) { return !moves(bodies, i); }

/// Whether the body is slender and moves.
inline bool is_bar(const Bodies& bodies, BodyIndex i) { return moves(bodies, i) && is_slender(bodies.inertia[i]); }

/// A body of a contact (a Manifold or a ContactGraph::Link) that moves, in whose island it lies.
template <class Contact>
BodyIndex mover_of(const Bodies& bodies, const Contact& contact) {
  return moves(bodies, contact.b) ? contact.b : contact.a;
}

/// Calls visit(link) for all awake contacts, by several workers at a time.
template <class Visit>
void for_awake(const Scratch& scratch, Visit visit) {
  const std::vector<ContactGraph::Link>& links = scratch.graph.links;
  for_manifolds(scratch, links.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (links[k].awake) visit(links[k]);
    }
  });
}

}  // namespace tumble::sim
