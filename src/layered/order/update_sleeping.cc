#include "src/layered/order/update_sleeping.h"

#include "src/layered/order/islands.h"
#include "src/world/body_check.h"

namespace tumble::sim {
namespace {

// J/kg, of the motion that parts a body from others; as if all of its mass turned at the distance of a corner, which is
// a bound.
double parting(const Scratch& scratch, BodyIndex i) {
  if (!scratch.overlaps.any) return 0;
  const SolverBody& body = scratch.overlaps.bodies[i];
  const Vec3& half = scratch.frames[i].half_extent;
  return 0.5 * (dot(body.velocity, body.velocity) + dot(body.spin, body.spin) * dot(half, half));
}

Islands join_touching(WorldState& state, Scratch& scratch) {
  const Bodies& bodies = state.bodies;
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

Status update_sleeping(WorldState& state, Scratch& scratch, double dt_s) {
  const WorldDef& def = state.def;
  Bodies& bodies = state.bodies;
  Islands islands = join_touching(state, scratch);
  const std::vector<std::uint8_t>& touching = scratch.sleeping.touching;
  std::vector<std::uint8_t>& restless = scratch.sleeping.restless;
  restless.assign(bodies.size(), 0);
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    if (!bodies.moves(i)) continue;
    const bool low = touching[i] != 0 && kinetic_energy(bodies, i) / bodies.mass[i] < def.freeze_energy &&
                     parting(scratch, i) < def.freeze_energy;
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

void hash_update_sleeping(const WorldState& state, const Scratch& /*scratch*/, Hasher& hasher) {
  const Bodies& bodies = state.bodies;
  hasher.add(std::span<const std::uint8_t>(bodies.frozen));
  hasher.add(std::span<const double>(bodies.low_energy_time));
  hash_velocities(state.bodies, hasher);
}

}  // namespace tumble::sim
