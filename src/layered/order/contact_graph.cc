#include "src/layered/order/contact_graph.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "src/layered/order/contact_motion.h"
#include "src/sharing/key_counts.h"
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
void for_bodies_of(const ContactGraph& graph, Worker::Share share, Visit visit) {
  for (std::size_t k = share.begin; k < share.end; ++k) {
    const Link& link = graph.links[k];
    if (!link.awake) continue;
    const auto end = static_cast<std::uint32_t>(2 * k);
    if (link.a != kGround) visit(link.a, end);
    visit(link.b, end + 1);
  }
}

// What one of several workers does to list the contacts of bodies that have homes: nobody else writes the lists of its
// bodies. An end of a body that is at home elsewhere is sent there.
class HomeLists {
 public:
  HomeLists(const WorldState& state, Scratch& scratch, const Worker& worker)
      : state_(state),
        scratch_(scratch),
        graph_(scratch.graph),
        homes_(scratch.homes),
        worker_(worker),
        sent_(scratch.sent_ends[worker.part]) {}

  void list() {
    sent_.clear();
    sent_.reserve(2 * graph_.links.size());  // so that a warm step allocates nothing
    for_own_bodies([&](const Homes::Range& range) {
      std::fill_n(graph_.start.begin() + range.begin + 1, range.end - range.begin, 0U);
    });
    scratch_.manifold_homes.for_own(worker_, graph_.links.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) graph_.links[k] = link_of(state_, scratch_, scratch_.manifolds[k]);
    });
    worker_.meet();
    for_own_ends([&](BodyIndex i, std::uint32_t end) {
      if (homes_.worker_of(i) == worker_.part) {
        ++graph_.start[i + 1];
      } else {
        sent_.emplace_back(i, end);
      }
    });
    worker_.meet();
    for_sent([&](BodyIndex i, std::uint32_t) { ++graph_.start[i + 1]; });
    find_places();
    std::uint32_t* const next = scratch_.sweep.next.data();
    for_own_ends([&](BodyIndex i, std::uint32_t end) {
      if (homes_.worker_of(i) == worker_.part) graph_.ends[next[i]++] = end;
    });
    for_sent([&](BodyIndex i, std::uint32_t end) { graph_.ends[next[i]++] = end; });
    for_own_bodies([&](const Homes::Range& range) {
      for (std::size_t i = range.begin; i < range.end; ++i) {
        const auto ends = graph_.ends.begin();
        if (!std::is_sorted(ends + graph_.start[i], ends + next[i])) std::sort(ends + graph_.start[i], ends + next[i]);
      }
    });
  }

 private:
  template <class Visit>
  void for_own_bodies(Visit visit) const {
    for (const Homes::Range& range : homes_.of(worker_.part)) visit(range);
  }
  template <class Visit>
  void for_own_ends(Visit visit) const {
    scratch_.manifold_homes.for_own(worker_, graph_.links.size(), [&](std::size_t begin, std::size_t end) {
      for_bodies_of(graph_, {begin, end}, visit);
    });
  }
  template <class Visit>
  void for_sent(Visit visit) const {
    for (unsigned part = 0; part < worker_.parts; ++part) {
      for (const auto& [i, end] : scratch_.sent_ends[part]) {
        if (homes_.worker_of(i) == worker_.part) visit(i, end);
      }
    }
  }

  // Makes the counts behind each body into places.
  void find_places() {
    std::vector<std::uint32_t>& before = scratch_.ends_before;  // by range
    for_own_bodies([&](const Homes::Range& range) {
      const auto counts = graph_.start.begin() + range.begin + 1;
      before[range.number + 1] = std::accumulate(counts, counts + (range.end - range.begin), 0U);
    });
    worker_.meet();
    if (worker_.first()) {
      before[0] = graph_.start[0] = 0;
      std::partial_sum(before.begin(), before.end(), before.begin());
      graph_.ends.resize(before.back());
    }
    worker_.meet();
    for_own_bodies([&](const Homes::Range& range) {
      std::uint32_t at = before[range.number];
      for (std::size_t i = range.begin; i < range.end; ++i) {
        scratch_.sweep.next[i] = at;
        at = graph_.start[i + 1] += at;
      }
    });
    worker_.meet();
  }

  const WorldState& state_;
  Scratch& scratch_;
  ContactGraph& graph_;
  const Homes& homes_;
  Worker worker_;
  OwnList<std::pair<BodyIndex, std::uint32_t>>& sent_;
};

}  // namespace

void connect_contacts(const WorldState& state, Scratch& scratch) {
  ContactGraph& graph = scratch.graph;
  const std::size_t n = state.bodies.size(), manifolds = scratch.manifolds.size();
  graph.links.resize(manifolds);
  graph.start.resize(n + 1);
  const unsigned parts = part_count(scratch.workers, manifolds, kManifoldsAPart);
  if (parts > 1 && scratch.homes.fit(n, parts)) {
    scratch.sent_ends.resize(std::max<std::size_t>(scratch.sent_ends.size(), parts));
    scratch.ends_before.resize(scratch.homes.size() + 1);
    scratch.sweep.next.resize(std::max(scratch.sweep.next.size(), n));
    work_together(scratch.workers, parts, [&](const Worker& worker) { HomeLists(state, scratch, worker).list(); });
    return;
  }
  work_together(scratch.workers, parts, [&](const Worker& worker) {
    const Worker::Share share = worker.share(manifolds);
    for (std::size_t k = share.begin; k < share.end; ++k) {
      graph.links[k] = link_of(state, scratch, scratch.manifolds[k]);
    }
    KeyCounts counts(scratch.sweep.next, n, worker);
    for_bodies_of(graph, share, [&](BodyIndex i, std::uint32_t) { counts.add(i); });
    const std::uint32_t all = counts.find_places([&](std::size_t i, std::uint32_t at) { graph.start[i] = at; });
    if (worker.first()) {
      graph.start[n] = all;
      graph.ends.resize(all);
    }
    worker.meet();
    for_bodies_of(graph, share, [&](BodyIndex i, std::uint32_t end) { graph.ends[counts.take(i)] = end; });
  });
}

}  // namespace tumble::sim
