#include "src/layered/order/assign_levels.h"

#include <algorithm>
#include <span>
#include <utility>

#include "src/layered/islands/awake_links.h"
#include "src/layered/islands/find_islands.h"
#include "src/layered/islands/hard_islands.h"
#include "src/layered/islands/sweep_counts.h"
#include "src/layered/order/contact_graph.h"
#include "src/layered/order/contact_motion.h"
#include "src/layered/order/find_hits.h"
#include "src/layered/order/waves.h"

namespace tumble::sim {
namespace {

constexpr std::uint32_t kUnreached = 0xffffffffU;

using Link = ContactGraph::Link;

// A body of level 1 touches something at rest. From there the levels go from contact to contact, those of one level at
// the same time.
void measure_levels(const WorldState& state, Scratch& scratch, const Worker& worker) {
  const Bodies& bodies = state.bodies;
  const ContactGraph& graph = scratch.graph;
  std::vector<std::uint32_t>& level = scratch.level;
  Waves waves(scratch.waves, bodies.size(), scratch.homes, worker);
  const auto for_own = [&](auto visit) { scratch.homes.for_own(worker, bodies.size(), visit); };
  for_own([&](std::size_t begin, std::size_t end) {
    std::fill(level.begin() + static_cast<std::ptrdiff_t>(begin), level.begin() + static_cast<std::ptrdiff_t>(end),
              kUnreached);
  });
  worker.meet();
  const auto reach = [&](BodyIndex i, std::uint32_t at, const Worker& by) {
    if (!at_rest(bodies, i) && by.exchange(level[i], kUnreached, at)) waves.push(i);
  };
  const bool at_home = graph.alone_among != 0;
  for_own([&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) {
      bool touches_rest = false, alone = at_home;
      for_ends(graph, i, [&](const ContactEnd& contact) {
        touches_rest |= graph.links[contact.manifold].touches && at_rest(bodies, contact.other);
        alone = alone && (at_rest(bodies, contact.other) || scratch.homes.worker_of(contact.other) == worker.part);
      });
      scratch.graph.alone[i] = alone ? 1 : 0;
      if (touches_rest) reach(i, 1, worker);
    }
  });
  // What a fast pair hits, it touches within the step: what lands is solved from the ground up at once.
  const Worker::Share pairs = worker.share(scratch.fast.pairs.size());
  for (std::size_t k = pairs.begin; k < pairs.end; ++k) {
    const auto [a, b] = scratch.fast.pairs[k];
    if (at_rest(bodies, a) != at_rest(bodies, b)) reach(at_rest(bodies, a) ? b : a, 1, worker);
  }
  waves.walk([&](BodyIndex i) {
    const std::uint32_t at = level[i] + 1;
    for_ends(graph, i, [&](const ContactEnd& end) {
      if (graph.links[end.manifold].touches) reach(end.other, at, who_adds(graph, end.other, worker));
    });
  });
}

// Whether a body that touches several things at rest meets this one: as a crate that slides on a floor meets a wall.
bool meets_beside(const Bodies& bodies, const Scratch& scratch, std::size_t k) {
  const ContactGraph& graph = scratch.graph;
  const auto beside = [&](const ContactEnd& contact) {
    return contact.manifold != k && at_rest(bodies, contact.other);
  };
  return any_end(graph, mover_of(bodies, graph.links[k]), beside) && meets(bodies, scratch, scratch.manifolds[k]);
}

// Layer 2 l holds the manifolds between levels l and l + 1, layer 2 l + 1 those within level l; layer 1, since things
// at rest need none, those by which a body meets one thing at rest beside another. In one layer with those that it
// rests on they would share its mass, and so stop it, and throw it back, in part.
std::uint32_t layer_for(const WorldState& state, const Scratch& scratch, std::size_t k) {
  const Link& m = scratch.graph.links[k];
  const auto level = [&](BodyIndex i) { return at_rest(state.bodies, i) ? 0U : scratch.level[i]; };
  const std::uint32_t a = level(m.a), b = level(m.b);
  if (a == kUnreached && b == kUnreached) return kUnreached;
  if (std::min(a, b) == 0) return meets_beside(state.bodies, scratch, k) ? 1U : 0U;
  return 2 * std::min(a, b) + (a == b ? 1U : 0U);
}

// Sorts the awake manifolds by layer; the layers of hard islands come behind the others. Each worker sorts those that
// are at home with it; a slot is a range of these (Homes), or an even share.
class Layers {
 public:
  // near_hard: for each body whether its island is hard; empty if none is.
  Layers(const WorldState& state, Scratch& scratch, std::span<const std::uint8_t> near_hard)
      : state_(state), scratch_(scratch), near_hard_(near_hard) {}

  void sort(const Worker& worker) {
    std::vector<Link>& links = scratch_.graph.links;
    const Homes& homes = scratch_.manifold_homes;
    std::uint32_t highest[2] = {};
    homes.for_own(worker, links.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        if (!links[k].awake) continue;
        links[k].layer = layer_for(state_, scratch_, k);
        if (links[k].layer != kUnreached) raise(highest[in_hard(links[k])], links[k].layer);
      }
    });
    for (int hard = 0; hard < 2; ++hard) worker.raise(highest_[hard], highest[hard]);
    worker.meet();
    if (worker.first()) make_groups(homes.slots(links.size(), worker.parts));
    worker.meet();
    homes.for_own_slots(worker, links.size(), [&](std::size_t begin, std::size_t end, std::size_t slot) {
      std::uint32_t* const counts = counts_of(slot);
      for (std::size_t k = begin; k < end; ++k) {
        if (!links[k].awake) continue;
        const SweepGroup& group = scratch_.sweep_groups[in_hard(links[k])];
        links[k].layer = group.begin + std::min(links[k].layer, group.end - group.begin - 1);
        scratch_.manifolds[k].layer = links[k].layer;
        ++counts[links[k].layer];
      }
    });
    worker.meet();
    if (worker.first()) place_layers(homes.slots(links.size(), worker.parts));
    worker.meet();
    homes.for_own_slots(worker, links.size(), [&](std::size_t begin, std::size_t end, std::size_t slot) {
      std::uint32_t* const next = counts_of(slot);
      for (std::size_t k = begin; k < end; ++k) {
        if (links[k].awake) scratch_.layered[next[links[k].layer]++] = static_cast<std::uint32_t>(k);
      }
    });
  }

 private:
  static constexpr std::size_t kLine = 16;  // numbers in a cache line

  // Numbers of a slot, which share no line with those of another one.
  [[nodiscard]] std::size_t row() const { return (scratch_.layer_start.size() / kLine + 2) * kLine; }
  [[nodiscard]] std::uint32_t* counts_of(std::size_t slot) { return scratch_.next_in_layer.data() + slot * row(); }

  static void raise(std::uint32_t& largest, std::uint32_t x) { largest = std::max(largest, x); }

  unsigned in_hard(const Link& m) const {
    return !near_hard_.empty() && near_hard_[mover_of(state_.bodies, m)] != 0 ? 1U : 0U;
  }
  void make_groups(std::size_t slots) {
    scratch_.sweep_groups.clear();
    std::uint32_t end = 0;
    for (int hard = 0; hard < (near_hard_.empty() ? 1 : 2); ++hard) {
      const std::uint32_t layers = highest_[hard] + 2;  // the last layer: islands that touch nothing at rest
      scratch_.sweep_groups.push_back({end, end + layers, most_sweeps(layers, hard == 1), hard == 1});
      end += layers;
    }
    scratch_.layer_start.resize(end + 1);
    scratch_.next_in_layer.reserve(std::max(slots, scratch_.manifold_pieces.size()) * row());
    scratch_.next_in_layer.assign(slots * row(), 0);
  }
  // From the counts of each slot, where its manifolds of each layer begin.
  void place_layers(std::size_t slots) {
    const std::size_t layers = scratch_.layer_start.size();
    std::uint32_t begin = 0;
    for (std::size_t layer = 0; layer < layers; ++layer) {
      scratch_.layer_start[layer] = begin;
      for (std::size_t slot = 0; slot < slots; ++slot) {
        begin += std::exchange(counts_of(slot)[layer], begin);
      }
    }
    scratch_.layered.resize(begin);
  }

  const WorldState& state_;
  Scratch& scratch_;
  std::span<const std::uint8_t> near_hard_;
  std::uint32_t highest_[2] = {};
};

}  // namespace

Status assign_levels(WorldState& state, Scratch& scratch, double dt_s) {
  connect_contacts(state, scratch);
  scratch.level.resize(state.bodies.size());
  scratch.graph.alone.resize(state.bodies.size());
  const unsigned parts = part_count(scratch.workers, scratch.manifolds.size(), kManifoldsAPart);
  scratch.graph.alone_among = scratch.homes.fit(state.bodies.size(), parts) ? parts : 0;
  work_together(scratch.workers, parts, [&](const Worker& worker) { measure_levels(state, scratch, worker); });
  find_islands(state, scratch);
  const std::span<const std::uint8_t> in_hard = find_hard_islands(state, scratch, dt_s);
  Layers layers(state, scratch, in_hard);
  work_together(scratch.workers, parts, [&](const Worker& worker) { layers.sort(worker); });
  find_hits(state, scratch);
  count_sweeps(state, scratch, in_hard);
  return {};
}

void hash_assign_levels(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  hasher.add(std::span<const std::uint32_t>(scratch.level));
  hasher.add(std::span<const std::uint32_t>(scratch.layer_start));
  hasher.add(std::span<const std::uint32_t>(scratch.layered));
}

}  // namespace tumble::sim
