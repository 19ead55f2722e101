#pragma once

#include "src/world/scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// Writes the impulses of all manifolds down for the next step.
void remember_contacts(const Scratch& scratch, ContactMemory& memory);

/// Adds contacts of other pairs, keeping the order.
void merge_contacts(ContactMemory& memory, const ContactMemory& added);

}  // namespace tumble::sim
