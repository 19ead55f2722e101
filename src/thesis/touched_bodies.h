#pragma once

#include "src/world/hash_on_the_way.h"
#include "src/world/scratch.h"

namespace tumble::sim {

/// Adds the numbers of the bodies in collisions: the phases after compute_impulses change no others, and read no
/// others. add(numbers, body) adds those of one body.
template <class Add>
void add_touched(const Scratch& scratch, Hasher& hasher, Add add) {
  GatheredNumbers numbers(&hasher);
  for (BodyIndex i = 0; i < scratch.touched.size(); ++i) {
    if (scratch.touched[i] != 0) add(numbers, i);
  }
}

}  // namespace tumble::sim
