#pragma once

#include "src/solve/contact_kernels.h"
#include "src/world/scratch.h"

namespace tumble::sim {

/// Copies the awake manifolds, prepared, into batches: side by side what has as many points. No sum depends on who
/// shares a batch with whom.
void batch_contacts(Scratch& scratch);

/// Takes impulses and separations back from the batches into manifolds and points.
void store_contacts(Scratch& scratch);

/// The work of one layer, and of all.
ContactWork contacts_of_layer(Scratch& scratch, std::size_t layer, double substep_s);
ContactWork all_contacts(Scratch& scratch, double substep_s);

}  // namespace tumble::sim
