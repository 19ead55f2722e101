#include "src/layered/solve/bounce_contacts.h"

#include "src/layered/solve/contact_batches.h"
#include "src/layered/solve/solver_hashes.h"
#include "src/layered/solve/sweep_layers.h"
#include "src/world/manifold_hashes.h"

namespace tumble::sim {

Status bounce_contacts(World& world, double dt_s) {
  sweep_layers(world, Sweep::kRestitution, Direction::kUp, dt_s);
  store_contacts(world.mutable_scratch());
  return {};
}

void hash_bounce_contacts(const World& world, Hasher& hasher) {
  hash_solver_bodies(world, hasher);
  hash_manifolds(world, hasher);
}

}  // namespace tumble::sim
