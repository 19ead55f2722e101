#include "src/solve/apply_forces.h"

#include "src/math/grid.h"
#include "src/solve/contact_batches.h"
#include "src/solve/sweep_layers.h"

namespace tumble::sim {

Status apply_forces(World& world, double substep_s) {
  Scratch& scratch = world.mutable_scratch();
  const Vec3 fall = world.state().def.gravity * substep_s;
  for (BodyIndex i = 0; i < world.bodies().size(); ++i) {
    if (scratch.in_contact[i] == 0) continue;
    scratch.solver_sums[i].velocity += VelocityGrid::round(Vec3(fall * scratch.solver_bodies[i].weight));
  }
  contact_kernels(scratch.lanes).warm_start(all_contacts(scratch, substep_s));
  for (BodyIndex i = 0; i < world.bodies().size(); ++i) {
    scratch.solver_bodies[i].velocity = scratch.solver_sums[i].velocity;
    scratch.solver_bodies[i].spin = scratch.solver_sums[i].spin;
  }
  return {};
}

void hash_apply_forces(const World& world, Hasher& hasher) { hash_solution(world, hasher); }

}  // namespace tumble::sim
