#include "src/layered/solve/apply_forces.h"

#include "src/layered/solve/solver_hashes.h"
#include "src/layered/solve/sweep_layers.h"
#include "src/math/grid.h"
#include "src/world/for_bodies.h"

namespace tumble::sim {
namespace {

// m/s. A body with lent inertia has its own weight.
Vec3 gain_by(const Vec3& fall, const SolverBody& body) {
  return body.lent == Vec3::Zero() ? fall : Vec3(fall - body.lent * (dot(body.lent, fall) / body.inverse_mass));
}

}  // namespace

Status apply_forces(WorldState& state, Scratch& scratch, double substep_s) {
  const Vec3 fall = state.def.gravity * substep_s;
  for_bodies(scratch, state.bodies.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (scratch.in_contact[i] == 0) continue;
      SolverBody& body = scratch.solver_bodies[i];
      body.velocity += VelocityGrid::round(gain_by(fall, body));
    }
  });
  for (const FastBody& body : scratch.fast.none() ? std::span<const FastBody>() : scratch.fast.bodies) {
    if (body.flown_s == 0) continue;  // the flight to a meeting has brought a part of it
    scratch.solver_bodies[body.row].velocity -= VelocityGrid::round(Vec3(state.def.gravity * body.flown_s));
  }
  warm_start_layers(scratch, substep_s);
  return {};
}

// What warm starting takes from impulses that stopped a hit shows in the velocities.
void hash_apply_forces(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  add_solver_velocities(scratch, hasher);
}

}  // namespace tumble::sim
