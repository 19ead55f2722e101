#include "src/layered/order/update_sleeping.h"

#include "src/layered/order/islands.h"
#include "src/world/body_check.h"

namespace tumble::sim {
namespace {

Islands join_touching(World& world) {
  const Bodies& bodies = world.bodies();
  Scratch& scratch = world.mutable_scratch();
  std::vector<std::uint8_t>& touching = scratch.sleeping.touching;
  touching.assign(bodies.size(), 0);
  Islands islands(scratch.island_links, bodies.size());
  for (const Manifold& m : scratch.manifolds) {
    if (!touches(scratch, m)) continue;
    touching[m.b] = 1;
    if (m.a == kGround) continue;
    touching[m.a] = 1;
    if (bodies.is_static[m.a] == 0 && bodies.is_static[m.b] == 0) islands.join(m.a, m.b);
  }
  return islands;
}

}  // namespace

Status update_sleeping(World& world, double dt_s) {
  const WorldDef& def = world.state().def;
  Bodies& bodies = world.mutable_state().bodies;
  Islands islands = join_touching(world);
  const std::vector<std::uint8_t>& touching = world.scratch().sleeping.touching;
  std::vector<std::uint8_t>& restless = world.mutable_scratch().sleeping.restless;
  restless.assign(bodies.size(), 0);
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    if (!bodies.moves(i)) continue;
    const bool low = touching[i] != 0 && kinetic_energy(bodies, i) / bodies.mass[i] < def.freeze_energy;
    bodies.low_energy_time[i] = low ? bodies.low_energy_time[i] + dt_s : 0;
    if (bodies.low_energy_time[i] < def.freeze_time) restless[islands.of(i)] = 1;
  }
  for (BodyIndex i = 0; def.freezing && i < bodies.size(); ++i) {
    if (!bodies.moves(i) || restless[islands.of(i)] != 0) continue;
    bodies.frozen[i] = 1;
    bodies.low_energy_time[i] = 0;
    bodies.velocity.set(i, Vec3::Zero());
    bodies.spin.set(i, Vec3::Zero());
  }
  return {};
}

void hash_update_sleeping(const World& world, Hasher& hasher) {
  const Bodies& bodies = world.bodies();
  hasher.add(std::span<const std::uint8_t>(bodies.frozen));
  hasher.add(std::span<const double>(bodies.low_energy_time));
  hash_velocities(world, hasher);
}

}  // namespace tumble::sim
