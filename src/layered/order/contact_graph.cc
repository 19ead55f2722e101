#include "src/layered/order/contact_graph.h"

#include "src/base/key_counts.h"
#include "src/layered/order/contact_motion.h"
#include "src/world/islands.h"

namespace tumble::sim {
namespace {

using Link = ContactGraph::Link;

Link link_of(const WorldState& state, const Scratch& scratch, const Manifold& m) {
  if (m.asleep) return {m.a, m.b};
  const double pull = pull_along(state.def.gravity, m);
  const auto upper = static_cast<std::int8_t>(pull > 0 ? 1 : pull < 0 ? -1 : 0);
  return {m.a, m.b, 0, static_cast<std::uint8_t>(m.count), true, touches(scratch, m), upper};
}

// Calls visit(body, end) for both bodies of the awake manifolds [begin, end).
template <class Visit>
void for_bodies(const ContactGraph& graph, Worker::Share share, Visit visit) {
  for (std::size_t k = share.begin; k < share.end; ++k) {
    const Link& link = graph.links[k];
    if (!link.awake) continue;
    const auto end = static_cast<std::uint32_t>(2 * k);
    if (link.a != kGround) visit(link.a, end);
    visit(link.b, end + 1);
  }
}

}  // namespace

void connect_contacts(const WorldState& state, Scratch& scratch) {
  ContactGraph& graph = scratch.graph;
  const std::size_t n = state.bodies.size(), manifolds = scratch.manifolds.size();
  graph.links.resize(manifolds);
  graph.start.resize(n + 1);
  const unsigned parts = part_count(scratch.workers, manifolds, kManifoldsAPart);
  work_together(scratch.workers, parts, [&](const Worker& worker) {
    const Worker::Share share = worker.share(manifolds);
    for (std::size_t k = share.begin; k < share.end; ++k) {
      graph.links[k] = link_of(state, scratch, scratch.manifolds[k]);
    }
    KeyCounts counts(scratch.sweep.next, n, worker);
    for_bodies(graph, share, [&](BodyIndex i, std::uint32_t) { counts.add(i); });
    const std::uint32_t all = counts.find_places([&](std::size_t i, std::uint32_t at) { graph.start[i] = at; });
    if (worker.first()) {
      graph.start[n] = all;
      graph.ends.resize(all);
    }
    worker.meet();
    for_bodies(graph, share, [&](BodyIndex i, std::uint32_t end) { graph.ends[counts.take(i)] = end; });
  });
}

}  // namespace tumble::sim
