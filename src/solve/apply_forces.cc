#include "src/solve/apply_forces.h"

#include "src/math/grid.h"
#include "src/solve/sweep_layers.h"

namespace tumble::sim {

Status apply_forces(World& world, double substep_s) {
  Scratch& scratch = world.mutable_scratch();
  const Vec3 fall = world.state().def.gravity * substep_s;
  for (BodyIndex i = 0; i < world.bodies().size(); ++i) {
    if (scratch.in_contact[i] == 0) continue;
    scratch.next_velocity.add(i, VelocityGrid::round(Vec3(fall * scratch.solver_bodies[i].weight)));
  }
  for (const std::uint32_t k : scratch.layered) {
    const Manifold& m = scratch.manifolds[k];
    add_wrench(scratch, m, warm_wrench(m, points_of(scratch, m)));
  }
  for (BodyIndex i = 0; i < world.bodies().size(); ++i) {
    scratch.solver_bodies[i].velocity = scratch.next_velocity[i];
    scratch.solver_bodies[i].spin = scratch.next_spin[i];
  }
  return {};
}

void hash_apply_forces(const World& world, Hasher& hasher) { hash_solution(world, hasher); }

}  // namespace tumble::sim
