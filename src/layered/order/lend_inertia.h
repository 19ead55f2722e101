#pragma once

#include <span>
#include <vector>

#include "src/layered/order/waves.h"
#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Whether a weight that presses at (x, y) does so between the points: within their convex hull or on its edge. No
/// order of points and no image of the scene shows. m
bool press_between(std::span<const WeightScratch::SupportPoint> points, double x, double y);

/// kg, by body, the sum of its supports' normals times their loads, in the place of the direction that lend_inertia
/// makes of it.
inline std::vector<Vec3>& upward_of(Scratch& scratch) { return scratch.lent_along; }

/// Finds the bodies that are *held*: their weight and all that they bear press between points that touch ground, a body
/// that does not move, or a body that is held; nothing that falls or topples is. Among these, finds those that are
/// *settled*: all that bears weight on them is held too. Reads what carry_weights has found.
/// waves: of the bodies that bear on others, each after all above.
void find_held(Scratch& scratch, const Waves& waves);

/// Whether a new contact may start from its load: all loads that belong to it start as well, above and below.
bool may_start(const WeightScratch& own, const WeightScratch::Support& support);

/// Lends the inertia of heavy bodies to the light ones that hold them up: the number of sweeps until an impulse has
/// passed a contact is about the ratio of the two masses. Only a held body is lent any, along its supports' normals,
/// where it moves little, and for turns about axes across; all other motion keeps its momentum.
/// Reads:  mass; held, offered, upward_of, and what carry_weights has found
/// Writes: solver_mass, lent_along
/// Order:  maxima, and sums of grid doubles
void lend_inertia(const WorldState& state, Scratch& scratch, const Waves& waves);

}  // namespace tumble::sim
