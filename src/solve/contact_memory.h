#pragma once

#include "src/world/world.h"

namespace tumble::sim {

/// Writes the impulses of all manifolds down for the next step.
void remember_contacts(const Scratch& scratch, ContactMemory& memory);

/// Gives a new world's frozen bodies their neighbours to remember, so that they sleep and wake as islands.
void find_first_contact_memory(World& world);

}  // namespace tumble::sim
