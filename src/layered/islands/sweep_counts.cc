#include "src/layered/islands/sweep_counts.h"

#include <algorithm>

#include "src/layered/islands/awake_links.h"
#include "src/layered/islands/later_numbers.h"
#include "src/world/for_bodies.h"

namespace tumble::sim {
namespace {

// Sweeps grow with the levels: an impulse passes a limited number of levels in one sweep.
constexpr int kLevelsPerSweep = 5;  // measured: columns of 8 that sway after a fall come to rest with two, not with one
constexpr int kSweepsMax = 10;
constexpr std::uint32_t kFewestLayers = 2;  // of a body that touches what is at rest, and of one that touches nothing
constexpr std::uint8_t kHitSweeps = 2;      // else a column that lands goes on into the ground for a substep
constexpr int kHitOnOneSweeps = 4;  // of what falls on one body that lies: two halve what is left, six throw it up
constexpr std::uint8_t kHitSweepsMax = 8;  // leave half a percent of a hit in a corner, four leave seven
constexpr int kLevelsPerHitSweep = 2;      // a column of 16 that lands gains half the energy that it gains with five
constexpr int kHardSweeps = 20;            // a bar that is pressed at one end turns and passes little on

// Two bodies bounce as one to half a percent with 8 turns of a bounce, and with 32 one that has ten times its mass on
// top to five. Columns of 16 that bounced as one would sway for more than ten seconds.
constexpr int kBounceTurnsMin = 8, kBounceTurnsShared = 128;

constexpr double kSweepDepth = 0.00005;  // m of overlap that is worth one more sweep
constexpr double kPartingMax = 20;

double overlap_of(const ContactBatches& all, const ContactBatch& batch, unsigned lane) {
  double deepest = 0;
  for (std::uint32_t k = batch.first; k < batch.first + batch.count; ++k) {
    deepest = std::max(deepest, -(all.points[k].separation.of[lane] + batch.slop.of[lane]));
  }
  return deepest;
}

// Calls visit(batch, sides, lane, island) for all contacts. Their bodies are those of the manifolds, for the rows in
// `sides` may be a worker's copies.
template <class Visit>
void for_lanes(const Bodies& bodies, Scratch& scratch, Visit visit) {
  ContactBatches& all = scratch.contact_batches;
  for_ranges(scratch.workers, all.batches.size(), kBatchesAPart, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const ContactBatch& batch = all.batches[k];
      for (unsigned lane = 0; lane < batch.used; ++lane) {
        const Manifold& m = scratch.manifolds[all.order[batch.members + lane]];
        visit(batch, all.sides[k], lane, scratch.islands.of[mover_of(bodies, m)]);
      }
    }
  });
}

// Of an island of so many layers. hit: kNotHit …
int sweeps_for(std::uint32_t layers, bool hard, std::uint8_t hit) {
  if (hard) return kHardSweeps;
  const int levels = static_cast<int>(layers - 1) / 2, usual = std::min(kSweepsMax, 1 + levels / kLevelsPerSweep);
  if (hit == kNotHit) return usual;
  const int for_hit = levels == 1 ? kHitOnOneSweeps : 1 + levels / kLevelsPerHitSweep;
  return std::max(usual, hit == kSharedHit ? kHitSweepsMax : std::min<int>(kHitSweepsMax, for_hit));
}

int bounce_turns(std::uint32_t layers) {
  return std::clamp(kBounceTurnsShared / static_cast<int>(layers), kBounceTurnsMin, kBounceTurnsMax);
}

// Contacts of an island mostly follow one another: each worker looks at its line once for all of them.
void count_layers(const Bodies& bodies, Scratch& scratch, const SweepGroup& soft) {
  IslandScratch& own = scratch.islands;
  const std::vector<ContactGraph::Link>& links = scratch.graph.links;
  for_manifolds(scratch, links.size(), [&](std::size_t begin, std::size_t end) {
    BodyIndex island = 0;
    std::uint32_t layers = 0;
    const auto raise_island = [&] {
      if (layers > 0) shared::raise(own.layers[island], layers);
    };
    for (std::size_t k = begin; k < end; ++k) {
      // The last layer has islands that touch nothing at rest, and so no levels.
      if (!links[k].awake || links[k].layer + 1 >= soft.end) continue;
      const BodyIndex at = own.hit[mover_of(bodies, links[k])];
      if (at != island) {
        raise_island();
        island = at;
        layers = 0;
      }
      layers = std::max(layers, links[k].layer + 2);
    }
    raise_island();
  });
}

}  // namespace

int most_sweeps(std::uint32_t layers, bool hard) { return sweeps_for(layers, hard, kSharedHit); }

int parting_sweeps(double deepest) { return 1 + static_cast<int>(std::min(kPartingMax, deepest / kSweepDepth)); }

void count_sweeps(const WorldState& state, Scratch& scratch, std::span<const std::uint8_t> in_hard) {
  const Bodies& bodies = state.bodies;
  IslandScratch& own = scratch.islands;
  const SweepGroup& soft = scratch.sweep_groups[0];
  const auto is_hard = [&](BodyIndex i) { return !in_hard.empty() && in_hard[i] != 0; };
  fill_bodies(scratch, bodies.size(), own.layers, kFewestLayers);
  fill_bodies(scratch, bodies.size(), own.most_sweeps, std::uint8_t{1});
  fill_bodies(scratch, bodies.size(), own.has_bar, std::uint8_t{0});
  count_layers(bodies, scratch, soft);
  for (const auto& [a, b] : scratch.fast.pairs) {
    if (!at_rest(bodies, a) && !at_rest(bodies, b)) own.most_sweeps[own.hit[a]] = kHitSweeps;
    for (const BodyIndex i : {a, b}) {
      if (is_bar(bodies, i)) own.has_bar[own.hit[i]] = 1;
    }
  }
  own.sweeps.resize(bodies.size());
  own.turns.resize(bodies.size());
  for_bodies(scratch, bodies.size(), [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<BodyIndex>(begin); i < end; ++i) {
      const BodyIndex island = own.hit[i];
      const auto sweeps = static_cast<std::uint8_t>(sweeps_for(own.layers[island], is_hard(i), own.hits[island]));
      own.sweeps[i] = std::max(sweeps, own.most_sweeps[island]);
      own.turns[i] = static_cast<std::uint8_t>(bounce_turns(own.layers[island]));
    }
  });
  if (scratch.fast.none()) return;
  // The contacts of fast pairs are solved after each sweep, as long as any contact of their island is swept.
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    std::uint8_t& most = own.most_sweeps[own.hit[i]];
    most = std::max(most, own.sweeps[i]);
  }
}

void count_parting_sweeps(const WorldState& state, Scratch& scratch) {
  const Bodies& bodies = state.bodies;
  const ContactBatches& all = scratch.contact_batches;
  std::vector<double>& deepest = deepest_overlaps(scratch);
  fill_bodies(scratch, bodies.size(), deepest, 0.0);
  for_lanes(bodies, scratch, [&](const ContactBatch& batch, const BatchSides& sides, unsigned lane, BodyIndex island) {
    if (sides.visited[lane] == 0) shared::raise(deepest[island], overlap_of(all, batch, lane));
  });
  for_lanes(bodies, scratch, [&](const ContactBatch&, BatchSides& sides, unsigned lane, BodyIndex island) {
    sides.parting[lane] = static_cast<std::uint8_t>(sides.sweeps[lane] + parting_sweeps(deepest[island]));
  });
}

}  // namespace tumble::sim
