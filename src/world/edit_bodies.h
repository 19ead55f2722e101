#pragma once

#include "src/base/result.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// A frozen body escapes when it would have more than this times freeze_energy (thesis III.D).
inline constexpr double kEscapeFactor = 2;

/// Checks a box against limits.h. Errors name the body and the value.
Status check_box(const BoxDef& box);

/// Adds a row for the box where its id belongs, rounded to the grids, and moves every index behind it up by one.
/// Precondition: check_box passed and the id is new.
void insert_body(WorldState& state, const BoxDef& box);

/// Removes row i, its pairs and its contacts; wakes what rested on it (thesis) or touched it (layered).
void erase_body(WorldState& state, BodyIndex i);

/// Brings a frozen body back to life, at rest. Its contact objects are forgotten. No effect on others.
void wake_body(WorldState& state, BodyIndex i);

}  // namespace tumble::sim
