#pragma once

#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Applies all stored outcomes at one time (thesis III.C). Impulses change the velocities of all bodies, frozen ones
/// included (update_freezing decides whether these escape); displacements change the positions of bodies that move. A
/// body that a displacement lifts loses vertical speed for the height.
/// Reads:  gains, displacement, touched, hit; gravity
/// Writes: velocity, spin, position; removed_energy
/// Errors: a body that is not finite or beyond limits.h
/// Source: thesis III.E: the potential energy of the displacement is removed from the vertical part of the kinetic
///         energy, as far as there is any. Differs: a body in a contact of restitution 1 pays the rest out of its
///         rotation. "Vertical" is along gravity, but along the displacement for a body that was
///         not hit: what slides down a slope keeps its speed.
Status apply_outcomes(WorldState& state, Scratch& scratch, double dt_s);
void hash_apply_outcomes(const WorldState& state, const Scratch& scratch, Hasher& hasher);

}  // namespace tumble::sim
