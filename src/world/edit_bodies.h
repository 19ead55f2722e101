#pragma once

#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// A frozen body escapes when an impulse would give it more than this times freeze_energy (thesis III.D).
inline constexpr double kEscapeFactor = 2;

/// Checks a box against limits.h. Errors name the body and the value.
Status check_box(const BoxDef& box);

/// Adds a row for the box at the place of its id, rounded to the grids, and adds one to every index at or behind that
/// row. Precondition: check_box passed and the id is new.
void insert_body(WorldState& state, const BoxDef& box);

/// Removes row i with its pairs and contacts; wakes the bodies that rested on it (thesis) or touched it (layered).
void erase_body(WorldState& state, BodyIndex i);

/// Wakes a frozen body, at rest, and forgets its contact objects. A body that is awake starts its time of rest anew: an
/// input has changed what it rests under. Changes no other body.
void wake_body(WorldState& state, BodyIndex i);

/// Starts the time of rest anew of body i and of the bodies that touch it or are near it, awake ones alone.
void restart_rest(WorldState& state, BodyIndex i);

}  // namespace tumble::sim
