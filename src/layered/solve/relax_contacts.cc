#include "src/layered/solve/relax_contacts.h"

#include "src/layered/solve/solver_hashes.h"
#include "src/layered/solve/sweep_layers.h"

namespace tumble::sim {

Status relax_contacts(WorldState& /*state*/, Scratch& scratch, double substep_s) {
  sweep_layers(scratch, Sweep::kHold, Direction::kUp, substep_s);
  return {};
}

void hash_relax_contacts(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  hash_solution(scratch, hasher);
}

}  // namespace tumble::sim
