#include "src/layered/solve/push_contacts.h"

#include "src/layered/solve/solver_hashes.h"
#include "src/layered/solve/sweep_layers.h"

namespace tumble::sim {

Status push_contacts(WorldState& /*state*/, Scratch& scratch, double substep_s) {
  sweep_layers(scratch, Sweep::kPush, Direction::kDown, substep_s);
  end_fast_push(scratch, substep_s);
  return {};
}

void hash_push_contacts(const WorldState& /*state*/, const Scratch& scratch, Hasher& hasher) {
  hash_solution(scratch, hasher);
}

}  // namespace tumble::sim
