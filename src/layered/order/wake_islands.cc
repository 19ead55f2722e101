#include "src/layered/order/wake_islands.h"

#include "src/layered/find/find_manifolds.h"
#include "src/layered/order/islands.h"
#include "src/world/edit_bodies.h"

namespace tumble::sim {
namespace {

bool lively(const World& world, BodyIndex i) {
  const Bodies& bodies = world.bodies();
  return bodies.moves(i) &&
         kinetic_energy(bodies, i) / bodies.mass[i] > kEscapeFactor * world.state().def.freeze_energy;
}

void find_disturbed(World& world) {
  const std::vector<std::uint8_t>& frozen = world.bodies().frozen;
  std::vector<BodyIndex>& disturbed = world.mutable_scratch().waking.disturbed;
  disturbed.clear();
  for (const Manifold& m : world.scratch().manifolds) {
    if (m.asleep || m.a == kGround) continue;
    if (frozen[m.a] != 0 && lively(world, m.b)) disturbed.push_back(m.a);
    if (frozen[m.b] != 0 && lively(world, m.a)) disturbed.push_back(m.b);
  }
}

}  // namespace

Status wake_islands(World& world, double dt_s) {
  find_disturbed(world);
  Scratch& scratch = world.mutable_scratch();
  const std::vector<BodyIndex>& disturbed = scratch.waking.disturbed;
  scratch.found_again = !disturbed.empty();
  if (disturbed.empty()) return {};
  Bodies& bodies = world.mutable_state().bodies;
  Islands islands(scratch.island_links, bodies.size());
  for (const Manifold& m : scratch.manifolds) {
    if (m.asleep && m.a != kGround && bodies.is_static[m.a] == 0 && bodies.is_static[m.b] == 0) islands.join(m.a, m.b);
  }
  std::vector<std::uint8_t>& wakes = scratch.waking.wakes;
  wakes.assign(bodies.size(), 0);
  for (const BodyIndex i : disturbed) wakes[islands.of(i)] = 1;
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    if (bodies.frozen[i] == 0 || wakes[islands.of(i)] == 0) continue;
    bodies.frozen[i] = 0;
    bodies.low_energy_time[i] = 0;
  }
  return find_manifolds(world, dt_s);
}

void hash_wake_islands(const World& world, Hasher& hasher) {
  hasher.add(std::span<const std::uint8_t>(world.bodies().frozen));
  hasher.add(std::span<const double>(world.bodies().low_energy_time));
  if (world.scratch().found_again) hash_find_manifolds(world, hasher);
}

}  // namespace tumble::sim
