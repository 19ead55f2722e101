#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Writes the impulses of all manifolds to the memory, for the warm start of the next step.
void remember_contacts(const Scratch& scratch, ContactMemory& memory);

/// Adds the contacts of `added` to the memory, in order. Precondition: no pair is in both.
void merge_contacts(ContactMemory& memory, const ContactMemory& added);

}  // namespace tumble::sim
