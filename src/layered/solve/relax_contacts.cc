#include "src/layered/solve/relax_contacts.h"

#include "src/layered/solve/solver_hashes.h"
#include "src/layered/solve/sweep_layers.h"

namespace tumble::sim {

Status relax_contacts(World& world, double substep_s) {
  sweep_layers(world, Sweep::kRelax, Direction::kUp, substep_s);
  return {};
}

void hash_relax_contacts(const World& world, Hasher& hasher) { hash_solution(world, hasher); }

}  // namespace tumble::sim
