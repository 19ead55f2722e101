#pragma once

#include "src/world/scratch.h"

namespace tumble::sim {

/// When two boxes that move on without turning will touch, s: 0 if they overlap or touch now, dt_s or more if they do
/// not within dt_s. velocity: of b against a, m/s.
///
/// Between boxes that do not turn, the separation along each axis of the separating-axis test changes evenly with time,
/// so advancing until the axis that is farthest apart is used up reaches the meeting in a few steps.
/// Source: conservative advancement, Mirtich (1996), section 2.3; exact here, since nothing turns.
double meeting_time(const BoxFrame& a, const BoxFrame& b, const Vec3& velocity, double dt_s);

/// b where it will be after time_s, seen from an a that stands still; on PositionGrid.
BoxFrame moved_on(const BoxFrame& b, const Vec3& velocity, double time_s);

}  // namespace tumble::sim
