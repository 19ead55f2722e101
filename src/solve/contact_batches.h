#pragma once

#include "src/solve/contact_kernels.h"
#include "src/world/world.h"

namespace tumble::sim {

/// Copies the awake manifolds into batches, layer by layer, with their shares of the bodies' masses. Which manifolds
/// share a batch shows in nothing but time.
void batch_contacts(World& world);

/// Finds the batches in which a point will bounce, once their approaches are known.
void mark_bounces(ContactBatches& all);

/// Takes impulses and separations back from the batches into manifolds and points.
void store_contacts(Scratch& scratch);

/// The work of one layer, and of all.
ContactWork contacts_of_layer(Scratch& scratch, std::size_t layer, double substep_s);
ContactWork all_contacts(Scratch& scratch, double substep_s);

}  // namespace tumble::sim
