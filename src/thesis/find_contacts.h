#pragma once

#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/world/scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// Narrow phase, second goal: one collision point for each entry of the Real Collision List.
/// Reads:  frames; contacts.a, b, planes
/// Writes: contacts.normal, depth, r_a, r_b; an entry whose boxes only touch (no corner behind the plane) is dropped
/// Source: thesis III.A.2, Figs. 5 and 6. Face to vertex: the corners behind the plane, weighted by how deep they are,
///         become one point. Edge to edge: the middle of the shortest line between the two edges. Differs: planes
///         that tie exactly each give a point and a normal, and the mean is used; coincident centres have no direction
///         at all and part vertically, the larger box downwards (two equal boxes in one place stay together, for no
///         rule that ignores ids could tell them apart).
/// Order:  every sum is of grid doubles, so no order of corners or planes shows
Status find_contacts(WorldState& state, Scratch& scratch, double dt_s);
void hash_find_contacts(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
