#include "src/layered/solve/relax_contacts.h"

#include "src/layered/find/contact_memory.h"
#include "src/layered/solve/contact_batches.h"
#include "src/layered/solve/fast_bodies.h"
#include "src/layered/solve/solver_hashes.h"
#include "src/layered/solve/sweep_layers.h"

namespace tumble::sim {

Status relax_contacts(WorldState& /*state*/, Scratch& scratch, double substep_s) {
  sweep_layers(scratch, Sweep::kRelax, Direction::kUp, substep_s);
  if (scratch.fast.none()) return {};
  mark_pressed(scratch);
  store_fast_contacts(scratch);
  const ManifoldList& found = scratch.fast.found;
  remember_contacts(found.manifolds, found.points, nullptr, scratch.fast.memory);
  return {};
}

void hash_relax_contacts(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  hash_solution(scratch, hasher);
}

}  // namespace tumble::sim
