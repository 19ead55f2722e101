#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// The main sweeps of a substep: finds the impulses with which contacts hold or slide, and pushes fast pairs that
/// overlap apart a little. part_overlaps parts the others.
/// Reads and writes: impulses in contact_batches; solver_bodies' velocity and spin
/// Order:  sweeps go down and up the levels in turn
Status push_contacts(WorldState& state, Scratch& scratch, double substep_s);
void hash_push_contacts(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
