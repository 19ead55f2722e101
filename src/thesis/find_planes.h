#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Narrow phase, first goal: finds for every pair of the Active Collision List a plane that separates the pair, or adds
/// the pair to the Real Collision List with the planes of the collision.
/// Reads:  frames, pairs, gravity
/// Writes: pairs.planes (0 for a pair in collision); contacts.a, b, planes
/// Source: thesis III.A.2. The plane of the last step is tried first, then the other kind (after a face the edges,
///         after an edge or nothing the faces, those of the larger box first, then of the lower one along gravity). A
///         pair in collision collides on its old plane, and without one on the plane of least overlap. Differs: the
///         best plane of a kind is taken, not "the first found", and planes that tie exactly are kept together, since
///         any choice among them would depend on the order of bodies or axes; see docs/thesis.md.
Status find_planes(WorldState& state, Scratch& scratch, double dt_s);
void hash_find_planes(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
