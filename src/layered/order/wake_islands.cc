#include "src/layered/order/wake_islands.h"

#include <algorithm>
#include <span>

#include "src/layered/find/find_manifolds.h"
#include "src/layered/find/find_near_pairs.h"
#include "src/layered/find/free_path.h"
#include "src/world/edit_bodies.h"
#include "src/world/for_bodies.h"
#include "src/world/islands.h"

namespace tumble::sim {
namespace {

bool lively(const WorldState& state, BodyIndex i) {
  const Bodies& bodies = state.bodies;
  return bodies.moves(i) && kinetic_energy(bodies, i) / bodies.mass[i] > kEscapeFactor * state.def.freeze_energy;
}

// Whether a lively body touches a sleeping one.
bool any_disturbed(const WorldState& state, const Scratch& scratch) {
  const std::vector<std::uint8_t>& frozen = state.bodies.frozen;
  std::uint8_t any = 0;
  for_manifolds(scratch, scratch.manifolds.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Manifold& m = scratch.manifolds[k];
      if (m.asleep || m.a == kGround) continue;
      if ((frozen[m.a] != 0 && lively(state, m.b)) || (frozen[m.b] != 0 && lively(state, m.a))) mark(any);
    }
  });
  return any != 0;
}

void find_disturbed(WorldState& state, Scratch& scratch, double dt_s) {
  const std::vector<std::uint8_t>& frozen = state.bodies.frozen;
  std::vector<BodyIndex>& disturbed = scratch.waking.disturbed;
  disturbed.clear();
  if (std::ranges::find(frozen, 1) == frozen.end()) return;
  for (const Manifold& m : any_disturbed(state, scratch) ? std::span(scratch.manifolds) : std::span<Manifold>()) {
    if (m.asleep || m.a == kGround) continue;
    if (frozen[m.a] != 0 && lively(state, m.b)) disturbed.push_back(m.a);
    if (frozen[m.b] != 0 && lively(state, m.a)) disturbed.push_back(m.b);
  }
  const FreePaths paths(state, scratch, dt_s);
  for (const auto& [a, b] : scratch.fast.pairs) {
    if (b == kGround || (frozen[a] == 0 && frozen[b] == 0)) continue;
    if (!lively(state, frozen[a] != 0 ? b : a)) continue;
    if (paths.follow(a, b, kContactSlack).kind != Approach::Kind::kPassing) disturbed.push_back(frozen[a] != 0 ? a : b);
  }
}

}  // namespace

Status wake_islands(WorldState& state, Scratch& scratch, double dt_s) {
  scratch.hasher = nullptr;  // find_manifolds would feed it with less than this phase writes
  find_disturbed(state, scratch, dt_s);
  const std::vector<BodyIndex>& disturbed = scratch.waking.disturbed;
  scratch.found_again = !disturbed.empty();
  if (disturbed.empty()) return {};
  Bodies& bodies = state.bodies;
  Islands islands(scratch.island_links, bodies.size(), scratch.workers);
  for (const Manifold& m : scratch.manifolds) {
    if (m.asleep && m.a != kGround && bodies.is_static[m.a] == 0 && bodies.is_static[m.b] == 0) islands.join(m.a, m.b);
  }
  std::vector<std::uint8_t>& wakes = scratch.waking.wakes;
  wakes.assign(bodies.size(), 0);
  for (const BodyIndex i : disturbed) wakes[islands.of(i)] = 1;
  std::vector<BodyIndex>& woken = scratch.waking.woken;
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    if (bodies.frozen[i] == 0 || wakes[islands.of(i)] == 0) continue;
    woken.push_back(i);
    bodies.frozen[i] = 0;
    bodies.low_energy_time[i] = 0;
  }
  Status found = find_manifolds(state, scratch, dt_s);
  woken.clear();
  return found;
}

void hash_wake_islands(const WorldState& state, const Scratch& scratch, Hasher& hasher) {
  hasher.add(std::span<const std::uint8_t>(state.bodies.frozen));
  hasher.add(std::span<const double>(state.bodies.low_energy_time));
  if (scratch.found_again) hash_find_manifolds(state, scratch, hasher);
}

}  // namespace tumble::sim
