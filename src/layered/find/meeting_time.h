#pragma once

#include "src/world/scratch.h"

namespace tumble::sim {

/// The time, s, until two boxes that move without turning touch. 0: the boxes overlap or touch now; dt_s or more: they
/// do not touch within dt_s. velocity: of b relative to a, m/s.
///
/// Without turning, the separation along each axis of the separating-axis test changes linearly with time. Advancing
/// until the largest separation is zero therefore never passes the meeting time, and takes few advances to reach it.
/// Source: conservative advancement, Mirtich (1996), section 2.3; exact here, since nothing turns.
double meeting_time(const BoxFrame& a, const BoxFrame& b, const Vec3& velocity, double dt_s);

/// Frame b after time_s of motion, while a stands still. The position lies on PositionGrid.
BoxFrame moved_on(const BoxFrame& b, const Vec3& velocity, double time_s);

}  // namespace tumble::sim
