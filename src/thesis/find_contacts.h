#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Narrow phase, second goal: finds one collision point for each entry of the Real Collision List.
/// Reads:  frames, gravity; contacts.a, b, planes
/// Writes: contacts.normal, depth, r_a, r_b, patch, patch_end; drops an entry whose boxes only touch (no corner behind
///         the plane)
/// Source: thesis III.A.2, Figs. 5 and 6. Face to vertex: the corners behind the plane, weighted by how deep they are,
///         become one point. Edge to edge: the middle of the shortest line between the two edges. Differs: against a
///         static box the point does not leave the face, and where it would, the depth is the least overlap; each of
///         several planes that tie exactly gives a point and a normal, and their means are used. Coincident centres
///         have no direction and part along gravity (along z without gravity), the larger box downwards; two equal
///         boxes in one place stay together, for only their ids could tell them apart.
/// Order:  every sum is of grid doubles, so no order of corners or planes shows
Status find_contacts(WorldState& state, Scratch& scratch, double dt_s);
void hash_find_contacts(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
