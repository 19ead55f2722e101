#include "src/layered/solve/push_contacts.h"

#include "src/layered/solve/solver_hashes.h"
#include "src/layered/solve/sweep_layers.h"

namespace tumble::sim {

Status push_contacts(World& world, double substep_s) {
  sweep_layers(world, Sweep::kPush, Direction::kDown, substep_s);
  return {};
}

void hash_push_contacts(const World& world, Hasher& hasher) { hash_solution(world, hasher); }

}  // namespace tumble::sim
