#include "src/layered/order/assign_levels.h"

#include <algorithm>

#include "src/layered/order/islands.h"
#include "src/layered/order/solver_body.h"

namespace tumble::sim {
namespace {

constexpr std::uint32_t kUnreached = 0xffffffffU;

// Sweeps grow with the levels: an impulse passes a limited number of levels in one sweep.
constexpr int kLevelsPerSweep = 5;  // measured: columns of 8 that sway after a fall come to rest with two, not with one
constexpr int kSweepsMax = 10;
constexpr int kHardSweeps = 20;      // a bar that is pressed at one end turns and passes little on
constexpr double kMuchHeavier = 16;  // times as heavy
constexpr double kStill = 0.01;      // m/s

bool at_rest(const Bodies& bodies, BodyIndex i) { return i == kGround || !bodies.moves(i); }

// Lists for each body the bodies that it touches.
void find_neighbours(const WorldState& state, const Scratch& scratch, LevelScratch& own) {
  const std::size_t n = state.bodies.size();
  own.start.assign(n + 1, 0);
  own.touching.clear();
  for (std::uint32_t k = 0; k < scratch.manifolds.size(); ++k) {
    const Manifold& m = scratch.manifolds[k];
    if (m.asleep || m.a == kGround || !touches(scratch, m)) continue;
    own.touching.push_back(k);
    ++own.start[m.a + 1];
    ++own.start[m.b + 1];
  }
  for (std::size_t i = 0; i < n; ++i) own.start[i + 1] += own.start[i];
  own.neighbours.resize(own.start[n]);
  own.next.assign(own.start.begin(), own.start.end() - 1);
  for (const std::uint32_t k : own.touching) {
    const Manifold& m = scratch.manifolds[k];
    own.neighbours[own.next[m.a]++] = m.b;
    own.neighbours[own.next[m.b]++] = m.a;
  }
}

void measure_levels(WorldState& state, Scratch& scratch) {
  const Bodies& bodies = state.bodies;
  LevelScratch& own = scratch.levels;
  find_neighbours(state, scratch, own);
  std::vector<std::uint32_t>& level = scratch.level;
  level.assign(bodies.size(), kUnreached);
  std::vector<BodyIndex>&front = own.front, &next = own.reached;
  next.clear();
  const auto reach = [&](BodyIndex i, std::uint32_t at) {
    if (at_rest(bodies, i) || level[i] <= at) return;
    level[i] = at;
    next.push_back(i);
  };
  for (const Manifold& m : scratch.manifolds) {
    if (m.asleep || !touches(scratch, m)) continue;
    if (at_rest(bodies, m.a)) reach(m.b, 1);
    if (at_rest(bodies, m.b)) reach(m.a, 1);
  }
  for (std::uint32_t at = 2; !next.empty(); ++at) {
    std::swap(front, next);
    next.clear();
    for (const BodyIndex i : front) {
      for (std::uint32_t k = own.start[i]; k < own.start[i + 1]; ++k) reach(own.neighbours[k], at);
    }
  }
}

// Whether bodies of very different masses touch and move: few sweeps leave over a part of the heavy one's impulse that
// throws the light one aside. At rest the loads that a contact starts from are all that it needs.
bool is_uneven(const Bodies& bodies, const Manifold& m) {
  if (at_rest(bodies, m.a) || at_rest(bodies, m.b)) return false;
  const auto [light, heavy] = std::minmax({bodies.mass[m.a], bodies.mass[m.b]});
  const Vec3 a = bodies.velocity[m.a], b = bodies.velocity[m.b];
  return heavy >= kMuchHeavier * light && std::max(dot(a, a), dot(b, b)) > kStill * kStill;
}

bool slender_mover(const Bodies& bodies, BodyIndex i) { return !at_rest(bodies, i) && is_slender(bodies.inertia[i]); }

// For each body whether its island is hard; empty if none is.
std::span<const std::uint8_t> find_hard_islands(WorldState& state, Scratch& scratch) {
  const Bodies& bodies = state.bodies;
  LevelScratch& own = scratch.levels;
  std::vector<BodyIndex>& hard = own.hard;
  hard.clear();
  for (const Manifold& m : scratch.manifolds) {
    if (m.asleep) continue;
    if (slender_mover(bodies, m.a) || is_uneven(bodies, m)) hard.push_back(m.a);
    if (slender_mover(bodies, m.b)) hard.push_back(m.b);
  }
  if (hard.empty()) return {};
  Islands islands(scratch.island_links, bodies.size());
  for (const Manifold& m : scratch.manifolds) {
    if (!at_rest(bodies, m.a) && !at_rest(bodies, m.b)) islands.join(m.a, m.b);
  }
  own.marked.assign(bodies.size(), 0);
  own.in_hard.resize(bodies.size());
  for (const BodyIndex i : hard) own.marked[islands.of(i)] = 1;
  for (BodyIndex i = 0; i < bodies.size(); ++i) own.in_hard[i] = own.marked[islands.of(i)];
  return own.in_hard;
}

// Layer 2 l holds the manifolds between levels l and l + 1, layer 2 l + 1 those within level l.
std::uint32_t layer_for(const WorldState& state, const Scratch& scratch, const Manifold& m) {
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

// Assigns layers, behind those of earlier groups, to the manifolds with belongs(manifold).
template <class Belongs>
void add_group(WorldState& state, Scratch& scratch, bool hard, Belongs belongs) {
  const std::uint32_t begin = scratch.sweep_groups.empty() ? 0 : scratch.sweep_groups.back().end;
  std::uint32_t highest = 0;
  for (Manifold& m : scratch.manifolds) {
    if (m.asleep || !belongs(m)) continue;
    m.layer = layer_for(state, scratch, m);
    if (m.layer != kUnreached) highest = std::max(highest, m.layer);
  }
  const std::uint32_t layers = highest + 2;  // the last layer: islands that touch nothing at rest
  for (Manifold& m : scratch.manifolds) {
    if (!m.asleep && belongs(m)) m.layer = begin + std::min(m.layer, layers - 1);
  }
  scratch.sweep_groups.push_back({begin, begin + layers, sweeps_for(layers, hard), hard});
}

void sort_by_layer(Scratch& scratch) {
  const std::uint32_t layers = scratch.sweep_groups.back().end;
  scratch.layer_start.assign(layers + 1, 0);
  for (const Manifold& m : scratch.manifolds) {
    if (!m.asleep) ++scratch.layer_start[m.layer + 1];
  }
  for (std::uint32_t k = 0; k < layers; ++k) scratch.layer_start[k + 1] += scratch.layer_start[k];
  scratch.layered.resize(scratch.layer_start[layers]);
  std::vector<std::uint32_t>& next = scratch.levels.next;
  next.assign(scratch.layer_start.begin(), scratch.layer_start.end() - 1);
  for (std::uint32_t k = 0; k < scratch.manifolds.size(); ++k) {
    if (!scratch.manifolds[k].asleep) scratch.layered[next[scratch.manifolds[k].layer]++] = k;
  }
}

}  // namespace

Status assign_levels(WorldState& state, Scratch& scratch, double /*dt_s*/) {
  measure_levels(state, scratch);
  const std::span<const std::uint8_t> near_hard = find_hard_islands(state, scratch);
  const auto in_hard = [&](const Manifold& m) {
    if (near_hard.empty()) return false;
    return near_hard[at_rest(state.bodies, m.b) ? m.a : m.b] != 0;
  };
  scratch.sweep_groups.clear();
  add_group(state, scratch, false, [&](const Manifold& m) { return !in_hard(m); });
  if (!near_hard.empty()) add_group(state, scratch, true, in_hard);
  sort_by_layer(scratch);
  return {};
}

void hash_assign_levels(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  hasher.add(std::span<const std::uint32_t>(scratch.level));
  hasher.add(std::span<const std::uint32_t>(scratch.layer_start));
  hasher.add(std::span<const std::uint32_t>(scratch.layered));
}

}  // namespace tumble::sim
