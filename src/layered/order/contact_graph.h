#pragma once

#include <span>

#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Lists the awake contacts of each body from the manifolds. The lists are the same for any number of workers.
void connect_contacts(const WorldState& state, Scratch& scratch);

/// One end of a contact.
struct ContactEnd {
  std::uint32_t manifold = 0;
  bool is_b = false;
  BodyIndex other = kGround;
};

/// Whether is(end) for one of the awake contacts of a body.
template <class Is>
bool any_end(const ContactGraph& graph, BodyIndex i, Is is) {
  for (std::uint32_t k = graph.start[i]; k < graph.start[i + 1]; ++k) {
    const std::uint32_t manifold = graph.ends[k] / 2;
    const bool is_b = graph.ends[k] % 2 != 0;
    const ContactGraph::Link& link = graph.links[manifold];
    if (is(ContactEnd{manifold, is_b, is_b ? link.a : link.b})) return true;
  }
  return false;
}

/// Calls visit(end) for the awake contacts of a body.
template <class Visit>
void for_ends(const ContactGraph& graph, BodyIndex i, Visit visit) {
  any_end(graph, i, [&](const ContactEnd& end) {
    visit(end);
    return false;
  });
}

/// Who adds to a body while bodies in contact with it are treated in waves: a worker alone, where all of them are at
/// home with one worker, as is the body.
inline Worker who_adds(const ContactGraph& graph, BodyIndex i, const Worker& worker) {
  const bool alone = graph.alone_among == worker.parts && i != kGround && graph.alone[i] != 0;
  return alone ? Worker{worker.all, worker.part, 1} : worker;
}

}  // namespace tumble::sim
