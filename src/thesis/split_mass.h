#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/vec.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Several collisions of one body, each computed on its own, push too far where they push the same way: each of two
/// supports stops the whole body, and both together throw the body back. So the mass of a body is divided into parts,
/// of which each collision meets one. The number of parts, from 1 to the number of collisions, need not be whole: it is
/// how many times as much energy the sum of the body's gains carries as the gains carry one by one. No set of
/// collisions gains energy then: none gains any on its own, and the gains of parts carry at least the energy of their
/// sum. Source: Tonge, Benevolenski and Voroshilov (2012), Mass splitting for jitter-free parallel rigid body
/// simulation,
///         with as many parts as collisions.

/// J, twice: of a gain that would start from rest.
double gain_energy(const Bodies& bodies, const BoxFrame& frame, BodyIndex i, const Vec3& velocity, const Vec3& spin);

/// Divides no mass, counts the contacts of every body, and lists all contacts in split.again.
void reset_parts(const Contacts& contacts, std::size_t bodies, SplitScratch& split);

/// Raises the number of parts of every body that needs more, and returns whether there was any: then split.again lists
/// its collisions, whose impulses have to be computed again. After a few rounds the number of collisions is taken,
/// which is always enough. Reads:  contacts.a, b; gains; split.energy, changed; masses, frames
/// Writes: split.parts, raised, again
/// Order:  each sum of energies is exact on a grid that the energy of all gains together chooses
bool raise_parts(const WorldState& state, Scratch& scratch, int round);

}  // namespace tumble::sim
