#include "src/layered/order/assign_levels.h"

#include <algorithm>
#include <span>
#include <utility>

#include "src/layered/find/velocity_ranges.h"
#include "src/layered/order/contact_graph.h"
#include "src/layered/order/solver_body.h"
#include "src/layered/order/waves.h"
#include "src/world/islands.h"

namespace tumble::sim {
namespace {

constexpr std::uint32_t kUnreached = 0xffffffffU;

// Sweeps grow with the levels: an impulse passes a limited number of levels in one sweep.
constexpr int kLevelsPerSweep = 5;  // measured: columns of 8 that sway after a fall come to rest with two, not with one
constexpr int kSweepsMax = 10;
constexpr int kHardSweeps = 20;  // a bar that is pressed at one end turns and passes little on
constexpr double kStill = 0.01;  // m/s
constexpr double kPlate = 4;     // times as wide as thick

using Link = ContactGraph::Link;

bool at_rest(const Bodies& bodies, BodyIndex i) { return i == kGround || !bodies.moves(i); }

// A body of level 1 touches something at rest. From there the levels go from contact to contact, those of one level at
// the same time.
void measure_levels(const WorldState& state, Scratch& scratch, const Worker& worker) {
  const Bodies& bodies = state.bodies;
  const ContactGraph& graph = scratch.graph;
  std::vector<std::uint32_t>& level = scratch.level;
  Waves waves(scratch.waves, bodies.size(), worker);
  const Worker::Share share = worker.share(bodies.size());
  std::fill(level.begin() + static_cast<std::ptrdiff_t>(share.begin),
            level.begin() + static_cast<std::ptrdiff_t>(share.end), kUnreached);
  worker.meet();
  const auto reach = [&](BodyIndex i, std::uint32_t at) {
    if (!at_rest(bodies, i) && worker.exchange(level[i], kUnreached, at)) waves.push(i);
  };
  for (auto i = static_cast<BodyIndex>(share.begin); i < share.end; ++i) {
    bool touches_rest = false;
    for_ends(graph, i, [&](const ContactEnd& end) {
      touches_rest |= graph.links[end.manifold].touches && at_rest(bodies, end.other);
    });
    if (touches_rest) reach(i, 1);
  }
  waves.walk([&](BodyIndex i) {
    const std::uint32_t at = level[i] + 1;
    for_ends(graph, i, [&](const ContactEnd& end) {
      if (graph.links[end.manifold].touches) reach(end.other, at);
    });
  });
}

// Whether bodies of very different masses touch and move: few sweeps leave over a part of the heavy one's impulse that
// throws the light one aside. At rest the loads that a contact starts from are all that it needs.
bool is_uneven(const Bodies& bodies, const Link& m) {
  if (at_rest(bodies, m.a) || at_rest(bodies, m.b)) return false;
  const auto [light, heavy] = std::minmax({bodies.mass[m.a], bodies.mass[m.b]});
  const Vec3 a = bodies.velocity[m.a], b = bodies.velocity[m.b];
  return heavy >= kMuchHeavier * light && std::max(dot(a, a), dot(b, b)) > kStill * kStill;
}

bool is_plate(const Scratch& scratch, BodyIndex i) {
  if (i == kGround) return false;
  const Vec3& half_extent = scratch.frames[i].half_extent;
  return half_extent.maxCoeff() >= kPlate * half_extent.minCoeff();
}

// Whether a plate may be driven into another body, or that into it, by more than half a thickness before the next step:
// what few sweeps leave over of the hit would drive a stack of plates into itself. Cubes are parted in time. Not where
// a much heavier body hits: many sweeps at the same points would add up what each of them gives the light one too much.
bool is_hit_through(const Scratch& scratch, const Link& m, double dt_s) {
  if (scratch.ranges.empty() || scratch.hit_unevenly[m.b] != 0) return false;
  if (!is_plate(scratch, m.a) && !is_plate(scratch, m.b)) return false;
  if (m.a != kGround && scratch.hit_unevenly[m.a] != 0) return false;
  return m.a == kGround ? fall_if_hit(scratch, m.b, dt_s) > 0 : way_most_if_hit(scratch, m.a, m.b, dt_s) > 0;
}

bool slender_mover(const Bodies& bodies, BodyIndex i) { return !at_rest(bodies, i) && is_slender(bodies.inertia[i]); }

// Calls visit(link) for all awake manifolds, by several workers at a time.
template <class Visit>
void for_awake(const Scratch& scratch, Visit visit) {
  const std::vector<Link>& links = scratch.graph.links;
  for_ranges(scratch.workers, links.size(), kManifoldsAPart, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (links[k].awake) visit(links[k]);
    }
  });
}

// For each body whether its island is hard; empty if none is.
std::span<const std::uint8_t> find_hard_islands(const WorldState& state, Scratch& scratch, double dt_s) {
  const Bodies& bodies = state.bodies;
  LevelScratch& own = scratch.levels;
  const auto makes_hard = [&](const Link& m) {
    return slender_mover(bodies, m.a) || slender_mover(bodies, m.b) || is_uneven(bodies, m) ||
           is_hit_through(scratch, m, dt_s);
  };
  std::uint8_t any = 0;
  for_awake(scratch, [&](const Link& m) {
    if (makes_hard(m)) mark(any);
  });
  if (any == 0) return {};
  Islands islands(scratch.island_links, bodies.size(), scratch.workers);
  for_awake(scratch, [&](const Link& m) {
    if (!at_rest(bodies, m.a) && !at_rest(bodies, m.b)) islands.join(m.a, m.b);
  });
  own.marked.assign(bodies.size(), 0);
  own.in_hard.resize(bodies.size());
  for_awake(scratch, [&](const Link& m) {
    if (makes_hard(m)) mark(own.marked[islands.of(at_rest(bodies, m.a) ? m.b : m.a)]);
  });
  for_ranges(scratch.workers, bodies.size(), kBodiesAPart, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) own.in_hard[i] = own.marked[islands.of(i)];
  });
  return own.in_hard;
}

// Layer 2 l holds the manifolds between levels l and l + 1, layer 2 l + 1 those within level l.
std::uint32_t layer_for(const WorldState& state, const Scratch& scratch, const Link& m) {
  const auto level = [&](BodyIndex i) { return at_rest(state.bodies, i) ? 0U : scratch.level[i]; };
  const std::uint32_t a = level(m.a), b = level(m.b);
  if (a == kUnreached && b == kUnreached) return kUnreached;
  return 2 * std::min(a, b) + (a == b ? 1U : 0U);
}

int sweeps_for(std::uint32_t layers, bool hard) {
  const int levels = static_cast<int>(layers - 1) / 2;
  const int sweeps = std::min(kSweepsMax, 1 + levels / kLevelsPerSweep);
  return hard ? std::max(kHardSweeps, sweeps) : sweeps;
}

// Sorts the awake manifolds by layer; the layers of hard islands come behind the others. Each worker sorts a range.
class Layers {
 public:
  // near_hard: for each body whether its island is hard; empty if none is.
  Layers(const WorldState& state, Scratch& scratch, std::span<const std::uint8_t> near_hard)
      : state_(state), scratch_(scratch), near_hard_(near_hard) {}

  void sort(const Worker& worker) {
    std::vector<Link>& links = scratch_.graph.links;
    const Worker::Share share = worker.share(links.size());
    std::uint32_t highest[2] = {};
    for (std::size_t k = share.begin; k < share.end; ++k) {
      if (!links[k].awake) continue;
      links[k].layer = layer_for(state_, scratch_, links[k]);
      if (links[k].layer != kUnreached) raise(highest[in_hard(links[k])], links[k].layer);
    }
    for (int hard = 0; hard < 2; ++hard) worker.raise(highest_[hard], highest[hard]);
    worker.meet();
    if (worker.first()) make_groups(worker.parts);
    worker.meet();
    std::uint32_t* const next = scratch_.levels.next.data() + worker.part * scratch_.layer_start.size();
    for (std::size_t k = share.begin; k < share.end; ++k) {
      if (!links[k].awake) continue;
      const SweepGroup& group = scratch_.sweep_groups[in_hard(links[k])];
      links[k].layer = group.begin + std::min(links[k].layer, group.end - group.begin - 1);
      scratch_.manifolds[k].layer = links[k].layer;
      ++next[links[k].layer];
    }
    worker.meet();
    if (worker.first()) place_layers(worker.parts);
    worker.meet();
    for (std::size_t k = share.begin; k < share.end; ++k) {
      if (links[k].awake) scratch_.layered[next[links[k].layer]++] = static_cast<std::uint32_t>(k);
    }
  }

 private:
  static void raise(std::uint32_t& largest, std::uint32_t x) { largest = std::max(largest, x); }

  unsigned in_hard(const Link& m) const {
    return !near_hard_.empty() && near_hard_[at_rest(state_.bodies, m.b) ? m.a : m.b] != 0 ? 1U : 0U;
  }
  void make_groups(unsigned workers) {
    scratch_.sweep_groups.clear();
    std::uint32_t end = 0;
    for (int hard = 0; hard < (near_hard_.empty() ? 1 : 2); ++hard) {
      const std::uint32_t layers = highest_[hard] + 2;  // the last layer: islands that touch nothing at rest
      scratch_.sweep_groups.push_back({end, end + layers, sweeps_for(layers, hard == 1), hard == 1});
      end += layers;
    }
    scratch_.layer_start.resize(end + 1);
    scratch_.levels.next.assign(workers * scratch_.layer_start.size(), 0);
  }
  // From the counts of each worker, where its manifolds of each layer begin.
  void place_layers(unsigned workers) {
    const std::size_t layers = scratch_.layer_start.size();
    std::uint32_t begin = 0;
    for (std::size_t layer = 0; layer < layers; ++layer) {
      scratch_.layer_start[layer] = begin;
      for (std::size_t worker = 0; worker < workers; ++worker) {
        begin += std::exchange(scratch_.levels.next[worker * layers + layer], begin);
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
  const unsigned parts = part_count(scratch.workers, scratch.manifolds.size(), kManifoldsAPart);
  work_together(scratch.workers, parts, [&](const Worker& worker) { measure_levels(state, scratch, worker); });
  Layers layers(state, scratch, find_hard_islands(state, scratch, dt_s));
  work_together(scratch.workers, parts, [&](const Worker& worker) { layers.sort(worker); });
  return {};
}

void hash_assign_levels(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  hasher.add(std::span<const std::uint32_t>(scratch.level));
  hasher.add(std::span<const std::uint32_t>(scratch.layer_start));
  hasher.add(std::span<const std::uint32_t>(scratch.layered));
}

}  // namespace tumble::sim
