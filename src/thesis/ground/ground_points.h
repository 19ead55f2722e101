#pragma once

#include <cstddef>

#include "src/world/scratch.h"

namespace tumble::sim {

/// The first contact with the ground: they come after those of pairs.
std::size_t ground_begin(const Contacts& contacts);

/// find_contacts for bodies in the ground, in lanes: reads the entries from `begin` on, and writes those that touch
/// from `kept` on, which is at most `begin`. Returns the end of what it wrote.
/// Precondition: the kernels of scratch.lanes include these.
std::size_t find_ground_points(Scratch& scratch, std::size_t begin, std::size_t kept);

}  // namespace tumble::sim
