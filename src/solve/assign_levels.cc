#include "src/solve/assign_levels.h"

#include <algorithm>

#include "src/solve/islands.h"

namespace tumble::sim {
namespace {

constexpr std::uint32_t kUnreached = 0xffffffffU;

// For each body the others that it touches.
struct Neighbours {
  std::vector<std::uint32_t> start;
  std::vector<BodyIndex> body;
};

bool at_rest(const Bodies& bodies, BodyIndex i) { return i == kGround || !bodies.moves(i); }

Neighbours find_neighbours(const World& world) {
  const Scratch& scratch = world.scratch();
  const std::size_t n = world.bodies().size();
  Neighbours neighbours;
  neighbours.start.assign(n + 1, 0);
  std::vector<const Manifold*> touching;
  for (const Manifold& m : scratch.manifolds) {
    if (m.asleep || m.a == kGround || !touches(scratch, m)) continue;
    touching.push_back(&m);
    ++neighbours.start[m.a + 1];
    ++neighbours.start[m.b + 1];
  }
  for (std::size_t i = 0; i < n; ++i) neighbours.start[i + 1] += neighbours.start[i];
  neighbours.body.resize(neighbours.start[n]);
  std::vector<std::uint32_t> next(neighbours.start.begin(), neighbours.start.end() - 1);
  for (const Manifold* m : touching) {
    neighbours.body[next[m->a]++] = m->b;
    neighbours.body[next[m->b]++] = m->a;
  }
  return neighbours;
}

void measure_levels(World& world) {
  Scratch& scratch = world.mutable_scratch();
  const Bodies& bodies = world.bodies();
  const Neighbours neighbours = find_neighbours(world);
  std::vector<std::uint32_t>& level = scratch.level;
  level.assign(bodies.size(), kUnreached);
  std::vector<BodyIndex> front, next;
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
      for (std::uint32_t k = neighbours.start[i]; k < neighbours.start[i + 1]; ++k) reach(neighbours.body[k], at);
    }
  }
}

// Layer 2 l holds what joins level l to l + 1, layer 2 l + 1 what joins bodies of one level.
std::uint32_t layer_for(const World& world, const Manifold& m) {
  const auto level = [&](BodyIndex i) { return at_rest(world.bodies(), i) ? 0U : world.scratch().level[i]; };
  const std::uint32_t a = level(m.a), b = level(m.b);
  if (a == kUnreached && b == kUnreached) return kUnreached;
  return 2 * std::min(a, b) + (a == b ? 1U : 0U);
}

}  // namespace

Status assign_levels(World& world, double /*dt_s*/) {
  measure_levels(world);
  Scratch& scratch = world.mutable_scratch();
  std::uint32_t highest = 0;
  for (Manifold& m : scratch.manifolds) {
    if (m.asleep) continue;
    m.layer = layer_for(world, m);
    if (m.layer != kUnreached) highest = std::max(highest, m.layer);
  }
  const std::uint32_t layers = highest + 2;  // the last one: what hangs in the air
  scratch.layer_start.assign(layers + 1, 0);
  for (Manifold& m : scratch.manifolds) {
    if (m.asleep) continue;
    if (m.layer == kUnreached) m.layer = layers - 1;
    ++scratch.layer_start[m.layer + 1];
  }
  for (std::uint32_t k = 0; k < layers; ++k) scratch.layer_start[k + 1] += scratch.layer_start[k];
  scratch.layered.resize(scratch.layer_start[layers]);
  std::vector<std::uint32_t> next(scratch.layer_start.begin(), scratch.layer_start.end() - 1);
  for (std::uint32_t k = 0; k < scratch.manifolds.size(); ++k) {
    if (!scratch.manifolds[k].asleep) scratch.layered[next[scratch.manifolds[k].layer]++] = k;
  }
  return {};
}

void hash_assign_levels(const World& world, Hasher& hasher) {
  hasher.add(std::span<const std::uint32_t>(world.scratch().level));
  hasher.add(std::span<const std::uint32_t>(world.scratch().layer_start));
  hasher.add(std::span<const std::uint32_t>(world.scratch().layered));
}

}  // namespace tumble::sim
