#include "src/layered/order/contact_graph.h"

#include <algorithm>

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
  graph.start.assign(n + 1, 0);
  const unsigned parts = part_count(scratch.workers, manifolds, kManifoldsAPart);
  work_together(scratch.workers, parts, [&](const Worker& worker) {
    const Worker::Share share = worker.share(manifolds), bodies = worker.share(n);
    for (std::size_t k = share.begin; k < share.end; ++k) {
      graph.links[k] = link_of(state, scratch, scratch.manifolds[k]);
    }
    for_bodies(graph, share, [&](BodyIndex i, std::uint32_t) { worker.add(graph.start[i + 1], 1U); });
    worker.meet();
    if (worker.first()) {
      for (std::size_t i = 0; i < n; ++i) graph.start[i + 1] += graph.start[i];
      graph.ends.resize(graph.start[n]);
      graph.next.assign(graph.start.begin(), graph.start.end() - 1);
    }
    worker.meet();
    for_bodies(graph, share, [&](BodyIndex i, std::uint32_t end) { graph.ends[worker.add(graph.next[i], 1U)] = end; });
    if (worker.parts == 1) return;  // the ends of each body ascend
    worker.meet();
    for (std::size_t i = bodies.begin; i < bodies.end; ++i) {
      std::sort(graph.ends.begin() + graph.start[i], graph.ends.begin() + graph.start[i + 1]);
    }
  });
}

}  // namespace tumble::sim
