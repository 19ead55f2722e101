#include "src/layered/solve/bounce_contacts.h"

#include "src/layered/solve/contact_batches.h"
#include "src/layered/solve/solver_hashes.h"
#include "src/layered/solve/sweep_layers.h"
#include "src/world/manifold_hashes.h"

namespace tumble::sim {

Status bounce_contacts(WorldState& /*state*/, Scratch& scratch, double dt_s) {
  sweep_layers(scratch, Sweep::kRestitution, Direction::kUp, dt_s);
  store_contacts(scratch);
  return {};
}

void hash_bounce_contacts(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  hash_solver_bodies(scratch, hasher);
  hash_manifolds(scratch, hasher);
}

}  // namespace tumble::sim
