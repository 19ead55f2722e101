#pragma once

#include "src/kernels/contacts/contact_kernels.h"
#include "src/world/hash_on_the_way.h"
#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Marks the manifolds of which a point met fast enough to bounce. Reads each point's `approach`.
/// Returns whether there is one.
bool mark_bounces(const ContactWork& work);

/// Begins anew what the batches of which a manifold met fast have absorbed (ContactBatches::impacts). any: whether
/// there is one.
void list_impacts(ContactBatches& all, bool any);

/// Copies impulses, friction and separations from the batches back to manifolds and points, less what stopped bodies
/// (keep_borne.h); with a hasher, adds them. fall: m/s, what gravity gives in a substep.
void store_contacts(Scratch& scratch, Hasher* hasher, double fall);
/// Adds what store_contacts has copied to the manifolds [begin, end) of scratch.layered.
void add_stored_contacts(const Scratch& scratch, std::size_t begin, std::size_t end, GatheredNumbers& numbers);
void store_fast_contacts(Scratch& scratch);
/// Takes from the contacts of fast pairs that bounced in the last substep, or were taken along, what threw the bodies:
/// they keep four weights of the lighter one at most. Returns whether there is such a contact.
bool keep_borne_of_fast(Scratch& scratch, double fall);
void add_stored_fast_contacts(const FastContacts& fast, GatheredNumbers& numbers);

/// The direction of a sweep through the layers: kUp starts at the ground.
enum class Direction { kUp, kDown };

/// The data for the kernels: of all layers, of one layer of `all`, and of the batches [begin, end) of `work`.
ContactWork all_contacts(Scratch& scratch, double substep_s);
ContactWork contacts_of_layer(const Scratch& scratch, const ContactWork& all, std::size_t layer);
ContactWork fast_contacts(Scratch& scratch, double substep_s);
ContactWork part_of(const ContactWork& work, std::size_t begin, std::size_t end);

}  // namespace tumble::sim
