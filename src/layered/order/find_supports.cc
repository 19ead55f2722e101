#include "src/layered/order/find_supports.h"

#include "src/layered/order/contact_graph.h"
#include "src/layered/order/contact_motion.h"

namespace tumble::sim {

void find_supports(const Bodies& bodies, Scratch& scratch, const Worker& worker) {
  WeightScratch& own = scratch.weights;
  const ContactGraph& graph = scratch.graph;
  const std::size_t n = bodies.size();
  const auto count = [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) {
      std::uint32_t below = 0, above = 0;
      if (bodies.moves(i)) {
        for_ends(graph, i, [&](const ContactEnd& contact) {
          const int side = graph.links[contact.manifold].upper * (contact.is_b ? 1 : -1);
          below += side > 0 ? 1U : 0U;
          above += side < 0 && moves(bodies, contact.other) ? 1U : 0U;
        });
      }
      own.start[i + 1] = below;
      own.waiting_for[i] = above;
    }
  };
  scratch.homes.for_own(worker, n, count);
  worker.meet();
  if (worker.first()) {
    own.start[0] = 0;
    for (std::size_t i = 0; i < n; ++i) own.start[i + 1] += own.start[i];
    own.supports.resize(own.start[n]);
  }
  worker.meet();
  const auto list = [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) {
      if (!bodies.moves(i)) continue;
      WeightScratch::Support* next = own.supports.data() + own.start[i];
      for_ends(graph, i, [&](const ContactEnd& contact) {
        if (graph.links[contact.manifold].upper != (contact.is_b ? 1 : -1)) return;
        *next++ = {0, contact.manifold, i, moves(bodies, contact.other) ? contact.other : kGround};
      });
    }
  };
  scratch.homes.for_own(worker, n, list);
  worker.meet();
}

}  // namespace tumble::sim
