#include "src/layered/order/find_supports.h"

#include "src/layered/order/contact_graph.h"
#include "src/layered/order/contact_motion.h"

namespace tumble::sim {

void find_supports(const Bodies& bodies, Scratch& scratch, const Worker& worker) {
  WeightScratch& own = scratch.weights;
  const ContactGraph& graph = scratch.graph;
  const std::size_t n = bodies.size();
  const Worker::Share share = worker.share(n);
  // Calls visit(end) where body i is above, or below: side is 1 or −1.
  const auto for_side = [&](BodyIndex i, int side, auto visit) {
    for_ends(graph, i, [&](const ContactEnd& end) {
      if (graph.links[end.manifold].upper == (end.is_b ? side : -side)) visit(end);
    });
  };
  for (auto i = static_cast<BodyIndex>(share.begin); i < share.end; ++i) {
    std::uint32_t below = 0, above = 0;
    if (bodies.moves(i)) {
      for_side(i, 1, [&](const ContactEnd&) { ++below; });
      for_side(i, -1, [&](const ContactEnd& end) { above += moves(bodies, end.other) ? 1U : 0U; });
    }
    own.start[i + 1] = below;
    own.waiting_for[i] = above;
  }
  worker.meet();
  if (worker.first()) {
    own.start[0] = 0;
    for (std::size_t i = 0; i < n; ++i) own.start[i + 1] += own.start[i];
    own.supports.resize(own.start[n]);
  }
  worker.meet();
  for (auto i = static_cast<BodyIndex>(share.begin); i < share.end; ++i) {
    if (!bodies.moves(i)) continue;
    WeightScratch::Support* next = own.supports.data() + own.start[i];
    for_side(i, 1, [&](const ContactEnd& end) {
      *next++ = {0, end.manifold, i, moves(bodies, end.other) ? end.other : kGround};
    });
  }
  worker.meet();
}

}  // namespace tumble::sim
