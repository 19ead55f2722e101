#pragma once

#include "src/kernels/contact_kernels.h"
#include "src/world/scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// Finds the batches in which a point will bounce, once their approaches are known.
void mark_bounces(const ContactWork& work);

/// Takes impulses and separations back from the batches into manifolds and points.
void store_contacts(Scratch& scratch);

/// The work of one layer, of all, and of some of its batches.
ContactWork contacts_of_layer(Scratch& scratch, std::size_t layer, double substep_s);
ContactWork all_contacts(Scratch& scratch, double substep_s);
ContactWork part_of(const ContactWork& work, std::size_t begin, std::size_t end);

}  // namespace tumble::sim
