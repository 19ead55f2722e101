#pragma once

#include <span>

#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Writes the impulses of manifolds, ascending by pair, to the memory, for the warm start of the next step or substep.
void remember_contacts(std::span<const Manifold> manifolds, std::span<const ManifoldPoint> points, Workers* workers,
                       ContactMemory& memory);

/// Adds the contacts of `added` to the memory, in order. Precondition: no pair is in both. buffer: any; its memory is
/// used.
void merge_contacts(ContactMemory& memory, const ContactMemory& added, Workers* workers, ContactMemory& buffer);

}  // namespace tumble::sim
